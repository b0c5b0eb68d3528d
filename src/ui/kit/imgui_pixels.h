// Pixels as Dear ImGui has them.
#pragma once

#include <imgui.h>

#include "render/pixel.h"

namespace triscope {

inline Pixel toPixels(ImVec2 v) { return {static_cast<double>(v.x), static_cast<double>(v.y)}; }
inline ImVec2 toImVec2(Pixel p) { return {static_cast<float>(p.x), static_cast<float>(p.y)}; }
/// The mouse relative to an upper left corner on the screen.
inline Pixel mouseOn(ImVec2 corner) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  return toPixels({mouse.x - corner.x, mouse.y - corner.y});
}

}  // namespace triscope
