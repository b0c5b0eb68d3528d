// Lines as pixels see them: dashes cut out of polylines, and the outline of each straight piece.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "render/canvas.h"
#include "render/pixel.h"

namespace triscope {

/// The polyline cut into dashes; lengths of the pattern are multiplied by `unit` (the style's width, at least 1).
Paths dashed(std::span<const Pixel> polyline, const DashPattern& pattern, double unit);

/// A rectangle of this width about the segment from a to b.
std::array<Pixel, 4> segmentOutline(Pixel a, Pixel b, double width);

/// A circle as a closed polyline (the last point repeats the first) that is never off by a fortieth of a pixel.
std::vector<Pixel> circlePolyline(Pixel centre, double radius);

/// Dash lengths grow with the width beyond this, so that a bold line keeps its rhythm.
double dashUnit(float width);

}  // namespace triscope
