// Distance from a point to a segment.
#pragma once

#include <algorithm>

#include "core/base/point.h"

namespace triscope::support {

inline double distanceToSegment(Point p, Point a, Point b) {
  const double along = std::clamp(dot(p - a, b - a) / squaredDistance(a, b), 0.0, 1.0);
  return distance(p, a + along * (b - a));
}

}  // namespace triscope::support
