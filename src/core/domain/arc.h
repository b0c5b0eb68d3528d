// Circular arcs and circles from what a file gives.
#pragma once

#include <optional>

#include "core/domain/curve.h"

namespace triscope {

/// The arc from a over `through` to b; none when the three lie (nearly) on one line: radius beyond 1e5 chords.
std::optional<Curve> arcThrough(Point a, Point through, Point b);

/// A full circle, counter-clockwise from (centre.x + radius, centre.y).
Curve makeCircle(Point centre, double radius);

}  // namespace triscope
