#include "ui/panels.h"

#include <array>

namespace triscope {

std::span<const PanelInfo> panels() {
  static constexpr std::array<PanelInfo, 4> kPanels{{
      {"Stages", Side::left, drawStages},
      {"Layers", Side::left, drawLayers},
      {"Params", Side::left, drawParams},
      {"Inspect", Side::right, drawInspect},
  }};
  return kPanels;
}

}  // namespace triscope
