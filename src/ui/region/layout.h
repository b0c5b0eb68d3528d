// Where the regions of the window are. Fixed places; the borders beside the canvas can be dragged.
#pragma once

#include <imgui.h>

#include "ui/model/view.h"

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
  Region bottom;  // a panel above the timeline; empty when none is open
  Region timeline;
  Region status;
  Region legend;  // at the foot of the right column; empty where it has no room there
  Region leftSplitter;
  Region rightSplitter;
  Region bottomSplitter;
};

/// `menu` and `toolbar` are the heights of the bars. Side panels give way where the canvas would get too narrow: first
/// they get narrower, then the right one goes (its tabs move to the left), then the left one too unless it is asked
/// for. The caption gets more lines where it is narrow. `legend` is the size it needs, 0 when hidden.
Layout layoutOf(ImVec2 window, float menu, float toolbar, ImVec2 legend, const UiState& ui);

/// The canvas as one picture, or as two of the same size: run A at the left, the live run at the right.
struct Panes {
  Region pinned;
  Region live;
};
Panes panesOf(const Region& canvas, const UiState& ui);

/// Begins a Dear ImGui window that fills the region; call ImGui::End() in any case.
bool beginRegion(const char* name, const Region& region, ImVec2 padding, ImGuiWindowFlags flags = 0);

/// The borders that can be dragged.
void drawSplitters(const View& view, Orders& orders, const Layout& layout);

}  // namespace triscope
