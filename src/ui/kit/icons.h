// The signs on the toolbar, drawn as shapes so that they are crisp at every scale.
#pragma once

#include <imgui.h>

#include <cstdint>

namespace triscope {

enum class Icon : std::uint8_t {
  none,
  restart,
  stage_back,
  insertion_back,
  step_back,
  play,
  pause,
  step,
  insertion,
  stage,
  to_end,
  fit,
  camera,
  open,
  reload,
};

/// Fills the square of this side about `centre`.
void drawIcon(ImDrawList& list, Icon icon, ImVec2 centre, float side, ImU32 color);

}  // namespace triscope
