// Where the picture is looked at: framed, fitted and zoomed.
#pragma once

#include "ui/app/desk.h"

namespace triscope {

/// Shows the box whole, with a margin in pixels at 100 %.
void frameBox(UiState& ui, const Box& box, double marginAt100 = 0.0);
/// Shows all there is, and goes on doing so until the camera is moved. `above`: pixels to leave for headings.
void fit(Desk& desk, double above);
void zoomMiddle(Desk& desk, double factor);
/// Frames a triangle, and its neighbour `other` if that is not -1, with its surroundings; selects it.
void showWorst(Desk& desk, Slot slot, Slot other);

}  // namespace triscope
