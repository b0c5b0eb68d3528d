// The panels: each draws one thing from the view and returns orders. The table is what the window goes through.
#pragma once

#include <optional>
#include <span>

#include "ui/model/view.h"

namespace triscope {

enum class Side : std::uint8_t { left, right, bottom };

struct PanelInfo {
  Panel id;
  const char* name;  // on its tab, or on the button above which it opens
  Side side;
  void (*draw)(const View&, Orders&);
  std::optional<Action> opens = std::nullopt;  // shows and hides it: those at the bottom
};
/// One row per Panel, in order.
std::span<const PanelInfo> panels();
inline const PanelInfo& infoOf(Panel panel) { return panels()[static_cast<std::size_t>(panel)]; }

void drawLayers(const View& view, Orders& orders);
void drawParams(const View& view, Orders& orders);
void drawStages(const View& view, Orders& orders);
void drawInspect(const View& view, Orders& orders);
void drawWhy(const View& view, Orders& orders);
void drawHistory(const View& view, Orders& orders);
void drawNotes(const View& view, Orders& orders);
void drawBreakpoints(const View& view, Orders& orders);
void drawPlots(const View& view, Orders& orders);
void drawCompare(const View& view, Orders& orders);
void drawSweep(const View& view, Orders& orders);
/// The figures of the mesh against their bounds, a part of Inspect.
void drawMeshFigures(const View& view, Orders& orders);

}  // namespace triscope
