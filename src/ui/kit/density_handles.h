// Density constraints of the domain over the picture, and the mouse on them.
#pragma once

#include <vector>

#include "render/canvas.h"
#include "ui/model/view.h"

namespace triscope {

/// Where the handle of a constraint of a domain is: its point, the middle of its box, or on its loop. One on a loop can
/// be selected but not moved: it holds all along the loop, and has no place of its own.
Point handleOf(const Domain& domain, const DensityRequest& request);

/// Takes the mouse where it places or moves a constraint; to be called after the canvas' own item. True when it did:
/// then nothing else is to take it.
bool densityMouse(const View& view, Orders& orders, ImVec2 corner);

/// The handles, over a picture with this upper left corner.
void drawDensityHandles(const View& view, ImVec2 corner);

/// What the handles and their labels cover, in pixels of the picture.
std::vector<Rect> densityHandleRects(const View& view);

/// What the Inspect panel shows of the constraint that is selected.
void inspectRequest(const View& view, Orders& orders, DensityRequest request);

}  // namespace triscope
