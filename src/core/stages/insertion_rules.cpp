#include "core/stages/insertion_rules.h"

#include <algorithm>
#include <array>

#include "core/geometry/circumcircle.h"
#include "core/mesh/badness.h"
#include "core/mesh/edit.h"

namespace triscope {
namespace {

double squared(double x) { return x * x; }

// "Not below" up to rounding: a tie (an angle of exactly 30°) must not be left on the wrong side of a strict bound.
bool notBelow(double squaredMeasured, double squaredLimit) {
  return squaredMeasured >= squaredLimit * (1.0 - kBoundMargin);
}

double squaredShortestEdge(const Mesh& mesh, std::int32_t slot) {
  const Triangle& t = triangleAt(mesh, slot);
  const Point a = pointOf(mesh, t.v[0]), b = pointOf(mesh, t.v[1]), c = pointOf(mesh, t.v[2]);
  return std::min({squaredDistance(a, b), squaredDistance(b, c), squaredDistance(c, a)});
}

bool atCentre(const Shape& shape, double squaredLimit, std::int32_t other, Proposal& proposal) {
  proposal.at = shape.centre;
  proposal.measured = std::sqrt(shape.squaredRadius);
  proposal.limit = std::sqrt(squaredLimit);
  proposal.other = other;
  return true;
}

// Step 1: R ≥ h at the circumcentre.
bool step1(const MeshState& state, std::int32_t, const Shape& shape, Proposal& proposal) {
  const double limit = squared(edgeLengthAt(state.tree, shape.centre));
  return notBelow(shape.squaredRadius, limit) && atCentre(shape, limit, -1, proposal);
}

// Step 2: R ≥ the least h over the three apexes.
bool step2(const MeshState& state, std::int32_t slot, const Shape& shape, Proposal& proposal) {
  const Triangle& t = triangleAt(state.mesh, slot);
  const std::vector<std::uint8_t>& rank = state.mesh.density;
  const int least = std::min({rank[at(t.v[0])], rank[at(t.v[1])], rank[at(t.v[2])]});
  const double limit = squared(state.tree.minEdge * rankLength(least));
  return notBelow(shape.squaredRadius, limit) && atCentre(shape, limit, -1, proposal);
}

// Step 3: R ≥ e. Bounds the edge ratio, the angles and the aspect ratio (Theorem 1).
bool step3(const MeshState&, std::int32_t, const Shape& shape, Proposal& proposal) {
  return notBelow(shape.squaredRadius, shape.squaredShortest) && atCentre(shape, shape.squaredShortest, -1, proposal);
}

// Step 4: R ≥ e of an adjacent triangle. Not as the paper says, it passes by a pair whose areas are close already:
// along a row of nearly equilateral triangles each insertion would call for the next, against the density asked for.
bool step4(const MeshState& state, std::int32_t slot, const Shape& shape, Proposal& proposal) {
  const double own = twiceArea(state.mesh, slot);
  for (const std::int32_t across : triangleAt(state.mesh, slot).adj) {
    if (across < 0) continue;
    if (own < state.settings.step4AreaRatio * twiceArea(state.mesh, triangleOf(across))) continue;
    const double limit = squaredShortestEdge(state.mesh, triangleOf(across));
    if (notBelow(shape.squaredRadius, limit)) return atCentre(shape, limit, triangleOf(across), proposal);
  }
  return false;
}

// Step 5: over the edge p1p3 shared with an adjacent triangle of height h and shortest edge e, this triangle's apex p4
// is at least e + h from the edge's midpoint p5. Bounds the area ratio (Theorem 2).
bool step5(const MeshState& state, std::int32_t slot, const Shape&, Proposal& proposal) {
  const Mesh& mesh = state.mesh;
  for (int i = 0; i < 3; ++i) {
    const std::int32_t half = 3 * slot + i;
    const std::int32_t across = oppositeOf(mesh, half);
    if (across < 0) continue;
    const Point p1 = pointOf(mesh, startOf(mesh, half));
    const Point p3 = pointOf(mesh, endOf(mesh, half));
    const Point p2 = pointOf(mesh, apexOf(mesh, across));
    const Point p4 = pointOf(mesh, apexOf(mesh, half));
    const Point p5 = midpoint(p1, p3);
    const double edge = distance(p1, p3);
    const double height = cross(p2 - p1, p3 - p1) / edge;
    const double shortest = std::sqrt(std::min({squaredDistance(p1, p2), squaredDistance(p2, p3), edge * edge}));
    const double reach = distance(p5, p4);
    if (reach < (shortest + height) * (1.0 - kBoundMargin)) continue;
    proposal.at = p5 + (height / edge) * perpendicular(p3 - p1);
    proposal.measured = reach;
    proposal.limit = shortest + height;
    // Theorem 2 needs this; the circle of radius e about p0 does not always lie in the circumcircle of p1p3p4.
    proposal.nearest = shortest * (1.0 - kBoundMargin);
    proposal.other = triangleOf(across);
    return true;
  }
  return false;
}

}  // namespace

Shape shapeOf(const Mesh& mesh, std::int32_t slot) {
  const Triangle& t = triangleAt(mesh, slot);
  Shape shape{pointOf(mesh, t.v[0]), pointOf(mesh, t.v[1]), pointOf(mesh, t.v[2]), {}, 0.0, 0.0};
  const Circumcircle circle = circumcircle(shape.a, shape.b, shape.c);
  shape.centre = circle.centre;
  shape.squaredRadius = circle.squaredRadius;
  shape.squaredShortest = std::min(
      {squaredDistance(shape.a, shape.b), squaredDistance(shape.b, shape.c), squaredDistance(shape.c, shape.a)});
  return shape;
}

bool proposes(Stage step, const MeshState& state, std::int32_t slot, const Shape& shape, Proposal& proposal) {
  switch (step) {
    case Stage::step1:
      return step1(state, slot, shape, proposal);
    case Stage::step2:
      return step2(state, slot, shape, proposal);
    case Stage::step3:
      return step3(state, slot, shape, proposal);
    case Stage::step4:
      return step4(state, slot, shape, proposal);
    default:
      return step5(state, slot, shape, proposal);
  }
}

Quiet clearlyQuiet(const MeshState& state, std::int32_t slot, const Shape& shape) {
  constexpr double kClearly = 1.0 - 1e-6;  // far from a tie, whatever the order of the operations
  Quiet quiet;
  quiet.step3 = shape.squaredRadius < kClearly * shape.squaredShortest;
  quiet.bounds = quiet.step3;
  const std::array<Point, 3> corners{shape.a, shape.b, shape.c};
  const double own = cross(shape.b - shape.a, shape.c - shape.a);
  for (int i = 0; i < 3; ++i) {
    const std::int32_t across = oppositeOf(state.mesh, 3 * slot + i);
    if (across < 0) continue;
    const Point p1 = corners[static_cast<std::size_t>(next3(i))];
    const Point p3 = corners[static_cast<std::size_t>(prev3(i))];
    const Point p4 = corners[static_cast<std::size_t>(i)];
    const Point p2 = pointOf(state.mesh, apexOf(state.mesh, across));
    const double other = cross(p2 - p1, p3 - p1);
    if (!(std::max(own, other) < 3.0 * kClearly * std::min(own, other))) quiet.bounds = false;
    const double edge = squaredDistance(p1, p3);
    const double shortest = std::min({squaredDistance(p1, p2), squaredDistance(p2, p3), edge});
    const bool close = own < kClearly * state.settings.step4AreaRatio * other;
    if (!close && !(shape.squaredRadius < kClearly * shortest)) quiet.step4 = false;
    // With h = other / |p1 p3|. Most need no root: (e + h)² > e² + h².
    const double reach = squaredDistance(midpoint(p1, p3), p4);
    if (reach * edge < kClearly * (shortest * edge + other * other)) continue;
    if (!(std::sqrt(reach * edge) < kClearly * (std::sqrt(shortest * edge) + other))) quiet.step5 = false;
  }
  return quiet;
}

}  // namespace triscope
