#include "ui/app/legend_room.h"

#include "ui/region/regions.h"

namespace triscope {

void LegendRoom::look(ImVec2 window) {
  const UiState& ui = desk_.ui;
  Room room{window, ui.scale(), ui.look, ui.debug.bottom, ui.sidePanels, ui.pinned};
  if (room == room_) return;
  room_ = room;
  desk_.ui.legendPlace = LegendPlace::anywhere;
}

void LegendRoom::place(const View& view, const Layout& layout) {
  UiState& ui = desk_.ui;
  const ImVec2 needs = legendNeeds(view);
  const bool elsewhere = needs.y > 0.0f && layout.legend.size.y <= 0.0f;
  const bool folded = ui.legendPlace == LegendPlace::folded;
  ui.legendFolded = elsewhere && (folded || !legendMayCover(view, panesOf(layout.canvas, ui).live.size));
  ui.legendOver = ui.legendOver && ui.legendFolded;
  ui.legendOnCanvas = elsewhere && !ui.legendFolded;
  if (needs.y > 0.0f)
    ui.legendPlace = ui.legendFolded     ? LegendPlace::folded
                     : ui.legendOnCanvas ? LegendPlace::picture
                                         : LegendPlace::column;
}

}  // namespace triscope
