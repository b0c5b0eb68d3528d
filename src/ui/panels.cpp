#include "ui/panels.h"

#include <array>

namespace triscope {

std::span<const PanelInfo> panels() {
  static constexpr std::array<PanelInfo, 11> kPanels{{
      {"Stages", Side::left, drawStages},
      {"Layers", Side::left, drawLayers},
      {"Params", Side::left, drawParams},
      {"Inspect", Side::right, drawInspect},
      {"Why", Side::right, drawWhy},
      {"History", Side::right, drawHistory},
      {"Notes", Side::right, drawNotes},
      {"Breakpoints", Side::bottom, drawBreakpoints},
      {"Plots", Side::bottom, drawPlots},
      {"Compare", Side::bottom, drawCompare},
      {"Sweep", Side::bottom, drawSweep},
  }};
  return kPanels;
}

}  // namespace triscope
