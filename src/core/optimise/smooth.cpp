#include "core/optimise/smooth.h"

#include <cmath>

namespace triscope {
namespace {

struct StepLimits {
  double longest;  // of a step, in edge lengths wanted
  double still;    // below this it is none
  double wakes;    // above this it concerns the neighbours
  double floor;    // no triangle's area, twice, falls below this, in squares of that length
};
constexpr StepLimits kCentreStep{0.35, 0.004, 0.01, 1e-3};
constexpr StepLimits kShapeStep{0.25, 0.004, 0.008, 0.05};

constexpr int kHalvings = 3;
constexpr double kSizeWeight = 0.5;  // of S* in the sum of shapes

bool keepsFloor(const Ring& ring, Point hub, double floor) {
  for (int k = 0; k < ring.count; ++k)
    if (!(fanArea(ring, k, hub) > floor)) return false;
  return true;
}

SmoothStep limited(const Ring& ring, Point hub, double size, Point by, const StepLimits& limits) {
  const double squaredWay = squaredLength(by);
  if (squaredWay < squared(limits.still * size)) return {};
  const double longest = limits.longest * size;
  if (squaredWay > longest * longest) by = (longest / std::sqrt(squaredWay)) * by;
  const bool wakes = squaredWay > squared(limits.wakes * size);
  for (int halving = 0; halving < kHalvings; ++halving, by = 0.5 * by)
    if (keepsFloor(ring, hub + by, limits.floor * squared(size))) return {StepKind::moves, hub + by, wakes};
  return {StepKind::refused, hub + by, false};
}

}  // namespace

SmoothStep meanOfCircumcentres(const Ring& ring, Point hub, double size) {
  Point sum;
  double weight = 0.0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(ring.count); ++k) {
    const Point u = ring.at[k] - hub, w = ring.at[k + 1] - hub;
    const double area = cross(u, w), uu = squaredLength(u), ww = squaredLength(w);
    const double density = 1.0 / squared(squared(size + ring.sizes[k] + ring.sizes[k + 1]));
    // Area times the way to the circumcentre: no division by the area.
    sum = sum + (0.5 * density) * Point{w.y * uu - u.y * ww, u.x * ww - w.x * uu};
    weight += area * density;
  }
  return limited(ring, hub, size, (1.0 / weight) * sum, kCentreStep);
}

SmoothStep towardBestShape(const Ring& ring, Point hub, double size) {
  Point slope;
  double xx = 0.0, xy = 0.0, yy = 0.0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(ring.count); ++k) {
    const Point q = ring.at[k], r = ring.at[k + 1], u = q - hub, w = r - hub;
    const double inverse = 1.0 / cross(u, w);
    const double wanted = (size + ring.sizes[k] + ring.sizes[k + 1]) / 3.0;
    const double edges = squaredLength(u) + squaredLength(w) + squaredDistance(q, r);
    const double shape = (edges + kSizeWeight * kEquilateral * squared(wanted)) * inverse;
    const Point areaSlope{q.y - r.y, r.x - q.x};
    const Point s = inverse * (-2.0 * (u + w) - shape * areaSlope);
    slope = slope + s;
    xx += (4.0 - 2.0 * s.x * areaSlope.x) * inverse;
    yy += (4.0 - 2.0 * s.y * areaSlope.y) * inverse;
    xy -= (s.x * areaSlope.y + s.y * areaSlope.x) * inverse;
  }
  const double determinant = xx * yy - xy * xy;
  if (!(determinant > 0.0)) return {};
  const Point by{-(yy * slope.x - xy * slope.y) / determinant, -(xx * slope.y - xy * slope.x) / determinant};
  return limited(ring, hub, size, by, kShapeStep);
}

}  // namespace triscope
