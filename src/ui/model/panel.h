// The panels of the window, by name: what is drawn in them is in ui/panel.
#pragma once

#include <cstdint>

namespace triscope {

enum class Panel : std::uint8_t {
  stages,
  layers,
  params,
  inspect,
  why,
  history,
  notes,
  plots,
  breakpoints,
  compare,
  sweep,
};

}  // namespace triscope
