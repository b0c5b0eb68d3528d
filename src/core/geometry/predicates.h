// The only place where the sign of a determinant is decided.
// Both predicates are exact for every finite input whose products neither overflow nor underflow: coordinates
// that are zero or of magnitude 1e-64 … 1e70 are safe, mixed as they may be, since a product of four last digits
// is then still a double. A static error bound answers nearly always, expansion arithmetic behind it the rest
// (J. R. Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates",
// Discrete & Computational Geometry 18, 1997).
#pragma once

#include "core/base/point.h"

namespace triscope {

namespace detail {
/// Exact signs, reached only when the filter below cannot decide.
int orient2dExact(Point a, Point b, Point c);
int dotSignExact(Point apex, Point a, Point b);
int incircleExact(Point a, Point b, Point c, Point d);
}  // namespace detail

/// +1 when a, b, c turn left (counter-clockwise), -1 when they turn right, 0 when they are collinear.
inline int orient2d(Point a, Point b, Point c) {
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double det = left - right;
  const double bound = 3.3306690738754716e-16 * (std::fabs(left) + std::fabs(right));
  if (det > bound) return 1;
  if (det < -bound) return -1;
  return detail::orient2dExact(a, b, c);
}

/// +1 when a and b are seen from the apex under an acute angle, -1 under an obtuse one, 0 under a right one.
inline int dotSign(Point apex, Point a, Point b) {
  const double alongX = (a.x - apex.x) * (b.x - apex.x);
  const double alongY = (a.y - apex.y) * (b.y - apex.y);
  const double dot = alongX + alongY;
  const double bound = 3.3306690738754716e-16 * (std::fabs(alongX) + std::fabs(alongY));
  if (dot > bound) return 1;
  if (dot < -bound) return -1;
  return detail::dotSignExact(apex, a, b);
}

/// +1 when d lies inside the circle through the counter-clockwise a, b, c, -1 outside, 0 on it.
inline int incircle(Point a, Point b, Point c, Point d) {
  const double adx = a.x - d.x, ady = a.y - d.y;
  const double bdx = b.x - d.x, bdy = b.y - d.y;
  const double cdx = c.x - d.x, cdy = c.y - d.y;
  const double bc = bdx * cdy, cb = cdx * bdy;
  const double ca = cdx * ady, ac = adx * cdy;
  const double ab = adx * bdy, ba = bdx * ady;
  const double aLift = adx * adx + ady * ady;
  const double bLift = bdx * bdx + bdy * bdy;
  const double cLift = cdx * cdx + cdy * cdy;
  const double det = aLift * (bc - cb) + bLift * (ca - ac) + cLift * (ab - ba);
  const double permanent = (std::fabs(bc) + std::fabs(cb)) * aLift + (std::fabs(ca) + std::fabs(ac)) * bLift +
                           (std::fabs(ab) + std::fabs(ba)) * cLift;
  const double bound = 1.1102230246251577e-15 * permanent;
  if (det > bound) return 1;
  if (det < -bound) return -1;
  return detail::incircleExact(a, b, c, d);
}

/// The same from what is known of the corners as seen from d: twice the areas of the triangles d a b, d b c and d c a,
/// and the squared distances; 0 when incircle has to say. The corners run clockwise. By |bx cy| + |cx by| <= |b| |c| <=
/// (|b|² + |c|²) / 2 the error bound of the static filter is at most this one, whose last digits are rounded up.
inline int incircleSeen(double ab, double bc, double ca, double aSquared, double bSquared, double cSquared) {
  const double det = aSquared * bc + bSquared * ca + cSquared * ab;
  const double bound = 1.1103e-15 * (aSquared * bSquared + cSquared * (aSquared + bSquared));
  return det < -bound ? 1 : (det > bound ? -1 : 0);
}

}  // namespace triscope
