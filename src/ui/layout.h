// Where the regions of the window are. Fixed places; the borders beside the canvas can be dragged.
#pragma once

#include <imgui.h>

#include "ui/view.h"

namespace triscope {

struct Region {
  ImVec2 at;
  ImVec2 size;
};

struct Layout {
  Region toolbar;
  Region left;
  Region right;
  Region canvas;
  Region caption;
  Region status;
  Region leftSplitter;
  Region rightSplitter;
};

/// `top` is the height of the menu bar. Side panels give way before the canvas gets narrower than 200 px at 100 %.
Layout layoutOf(ImVec2 window, float top, const UiState& ui);

/// Begins a Dear ImGui window that fills the region; call ImGui::End() in any case.
bool beginRegion(const char* name, const Region& region, ImVec2 padding, ImGuiWindowFlags flags = 0);

/// The two borders that can be dragged.
void drawSplitters(const View& view, Orders& orders, const Layout& layout);

}  // namespace triscope
