#include "core/mesh/badness.h"

#include <algorithm>

#include "core/mesh/edit.h"

namespace triscope {
namespace {

constexpr double kAreaRatio = 3.0 * (1.0 - kBoundMargin);

struct Measures {
  double area = 0.0;      // twice
  double shortest = 0.0;  // squared
  double middle = 0.0;
  double longest = 0.0;
};

Measures measuresOf(const Mesh& mesh, Slot slot) {
  const Triangle& t = triangleAt(mesh, slot);
  const Point a = pointOf(mesh, t.v[0]), b = pointOf(mesh, t.v[1]), c = pointOf(mesh, t.v[2]);
  double l = squaredDistance(a, b), m = squaredDistance(b, c), n = squaredDistance(c, a);
  if (l > m) std::swap(l, m);
  if (m > n) std::swap(m, n);
  if (l > m) std::swap(l, m);
  return {cross(b - a, c - a), l, m, n};
}

// R²/e² with R = abc / (4 area): at least 1 when an angle is 30° or less. 1e300 for a triangle without area.
double radiusOverEdge(const Measures& m) {
  if (!(m.area > 0.0)) return 1e300;
  return m.middle * m.longest / (4.0 * m.area * m.area);
}

double aspect(const Measures& m) {
  if (!(m.area > 0.0)) return 1e300;
  const double a = std::sqrt(m.shortest), b = std::sqrt(m.middle), c = std::sqrt(m.longest);
  return a * b * c * (a + b + c) / (2.0 * m.area * m.area);
}

double areaRatio(double l, double r) {
  const double small = std::min(l, r);
  return small > 0.0 ? std::max(l, r) / small : 1e300;
}

// `counted(other)`: whether the pair with that neighbour is counted from its other side.
template <class Counted>
void add(Badness& badness, const Mesh& mesh, Slot slot, const Counted& counted) {
  const Measures m = measuresOf(mesh, slot);
  badness.shortest = std::min(badness.shortest, m.shortest);
  badness.worst = std::max(badness.worst, aspect(m));
  badness.edgeRatio = std::max(badness.edgeRatio, m.longest / m.shortest);
  if (m.longest > m.shortest + m.middle) ++badness.obtuse;
  const double radius = radiusOverEdge(m);
  badness.radius = std::max(badness.radius, radius);
  if (radius >= 1.0 - kBoundMargin) {
    ++badness.broken;
    badness.excess += std::min(radius, 1e6);
  }
  for (const Half across : triangleAt(mesh, slot).adj) {
    if (!across.exists()) continue;
    const Slot other = triangleOf(across);
    const double ratio = areaRatio(m.area, twiceArea(mesh, other));
    badness.areaRatio = std::max(badness.areaRatio, ratio);
    if (ratio < kAreaRatio || counted(other)) continue;
    ++badness.broken;
    badness.excess += std::min(ratio / 3.0, 1e6);
  }
}

}  // namespace

Badness badnessOf(const Mesh& mesh, const std::vector<Slot>& slots) {
  Badness badness;
  for (const Slot slot : slots) {
    // A pair inside the region is seen from both sides: count it from the lower slot.
    add(badness, mesh, slot,
        [&](Slot other) { return other < slot && std::find(slots.begin(), slots.end(), other) != slots.end(); });
  }
  return badness;
}

Badness badnessOf(const Mesh& mesh, Slot slot) {
  Badness badness;
  add(badness, mesh, slot, [](Slot) { return false; });
  return badness;
}

Breach breachOf(const Mesh& mesh, Slot slot) {
  const Measures m = measuresOf(mesh, slot);
  Breach breach;
  breach.shortest = m.shortest;
  // Most triangles are clearly within the bounds, which is seen without a division.
  if (!(m.middle * m.longest < 0.99 * 4.0 * m.area * m.area)) {
    const double radius = radiusOverEdge(m);
    if (radius >= 1.0 - kBoundMargin) {
      ++breach.broken;
      breach.excess += std::min(radius, 1e6);
    }
  }
  for (const Half across : triangleAt(mesh, slot).adj) {
    if (!across.exists() || triangleOf(across) < slot) continue;
    const double other = twiceArea(mesh, triangleOf(across));
    if (std::max(m.area, other) < 0.99 * kAreaRatio * std::min(m.area, other)) continue;
    const double ratio = areaRatio(m.area, other);
    if (ratio < kAreaRatio) continue;
    ++breach.broken;
    breach.excess += std::min(ratio / 3.0, 1e6);
  }
  return breach;
}

bool breaksBound(const Mesh& mesh, Slot slot) {
  const Measures m = measuresOf(mesh, slot);
  if (radiusOverEdge(m) >= 1.0 - kBoundMargin) return true;
  for (const Half across : triangleAt(mesh, slot).adj) {
    if (across.exists() && areaRatio(m.area, twiceArea(mesh, triangleOf(across))) >= kAreaRatio) return true;
  }
  return false;
}

}  // namespace triscope
