// The fixed regions of the window, and what lies over the picture. Each region fills the current Dear ImGui window.
#pragma once

#include <string>

#include "render/canvas.h"
#include "ui/model/view.h"

namespace triscope {

void drawMenuBar(const View& view, Orders& orders);
/// Of the toolbar in a window of this width: it takes more rows where it does not fit in one.
float toolbarHeight(const View& view, float width);
void drawToolbar(const View& view, Orders& orders);
void drawCanvas(const View& view, Orders& orders);
/// Over the upper left corner of one of two pictures: which run it is, and what sets it apart.
enum class Pane : std::uint8_t { pinned, live };
void drawPaneHeading(const View& view, Pane pane, ImVec2 corner, ImVec2 size);
/// Height that it may take of a picture of this height, with the gap above it.
float paneHeadingHeight(const View& view, float pane);
void drawCaption(const View& view, Orders& orders);
/// The sentence that the caption shows.
std::string captionNow(const View& view);
void drawTimeline(const View& view, Orders& orders);
void drawStatusBar(const View& view, Orders& orders);
void drawLegendRegion(const View& view, Orders& orders);
/// The legend over a picture with this upper left corner and size.
void overlayLegend(const View& view, ImVec2 corner, ImVec2 size);
/// Whether the legend over a picture of this size leaves enough of it.
bool legendMayCover(const View& view, ImVec2 size);
/// The part of a picture of this size that the legend or its button covers; empty when none.
Rect legendCovers(const View& view, ImVec2 size);
/// A button in the corner of a picture that stands for the legend, which shows while the mouse is on it.
void drawFoldedLegend(const View& view, Orders& orders, ImVec2 corner, ImVec2 size);
/// Over a picture with this upper left corner and size: work left behind can be restored.
void drawKeptOffer(const View& view, Orders& orders, ImVec2 corner, ImVec2 size);
/// Size of the legend with its padding; zero when there is none to show.
ImVec2 legendNeeds(const View& view);

}  // namespace triscope
