// The circle through the corners of a triangle, by + - * / only: the same bits with every compiler.
#pragma once

#include "core/base/point.h"

namespace triscope {

struct Circumcircle {
  Point centre;
  double squaredRadius = 0.0;
};

/// Worked out relative to a, so that a triangle far from the origin loses nothing but what its coordinates lost.
/// The radius is the distance from the centre to a before the centre is rounded to the plane's coordinates.
/// A triangle without area gives components that are not finite.
inline Circumcircle circumcircle(Point a, Point b, Point c) {
  const Point ab = b - a;
  const Point ac = c - a;
  const double abSquared = squaredLength(ab);
  const double acSquared = squaredLength(ac);
  const double scale = 0.5 / cross(ab, ac);
  const Point offset{(ac.y * abSquared - ab.y * acSquared) * scale, (ab.x * acSquared - ac.x * abSquared) * scale};
  return {a + offset, squaredLength(offset)};
}

inline Point circumcentre(Point a, Point b, Point c) { return circumcircle(a, b, c).centre; }
inline double squaredCircumradius(Point a, Point b, Point c) { return circumcircle(a, b, c).squaredRadius; }

}  // namespace triscope
