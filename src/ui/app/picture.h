// The picture on the canvas, of one run or of two.
#pragma once

#include "ui/app/parts.h"
#include "ui/region/layout.h"

namespace triscope {

/// Brings the scene and the camera up to date and draws the picture of a region, for the canvas to show.
void drawPicture(Parts& parts, const Region& region);
/// Pixels at the top of the picture that the headings of two runs cover; 0 for one.
double headingsAbove(Parts& parts);

}  // namespace triscope
