#include "core/method/stages/insertion_rules.h"

#include <algorithm>
#include <array>

#include "core/geometry/circumcircle.h"
#include "core/mesh/badness.h"
#include "core/mesh/edit.h"

namespace triscope {
namespace {

// "Not below" up to rounding: a tie (an angle of exactly 30°) must not be left on the wrong side of a strict bound.
bool notBelow(double squaredMeasured, double squaredLimit) {
  return squaredMeasured >= squaredLimit * (1.0 - kBoundMargin);
}

double squaredShortestEdge(const Mesh& mesh, Slot slot) {
  const Triangle& t = triangleAt(mesh, slot);
  const Point a = pointOf(mesh, t.v[0]), b = pointOf(mesh, t.v[1]), c = pointOf(mesh, t.v[2]);
  return std::min({squaredDistance(a, b), squaredDistance(b, c), squaredDistance(c, a)});
}

Circumcircle circleOf(const Mesh& mesh, Slot slot) {
  const Triangle& t = triangleAt(mesh, slot);
  return circumcircle(pointOf(mesh, t.v[0]), pointOf(mesh, t.v[1]), pointOf(mesh, t.v[2]));
}

// Straight over the middle of the shortest edge, where it sees the edge under a little more than 30°, or at the
// circumcentre, whichever is nearer to the edge: the off-centre (A. Üngör, 2004) for the bound R < e of step 3.
Point offCentre(const Mesh& mesh, Slot slot, Point centre) {
  constexpr double kHeight = 1.8;  // over the edge, of its length; at (2 + √3)/2 the angle is 30°
  const Triangle& t = triangleAt(mesh, slot);
  Point a, b;
  double shortest = 1e300;
  for (int i = 0; i < 3; ++i) {
    const Point p = pointOf(mesh, t.v[next3(i)]), q = pointOf(mesh, t.v[prev3(i)]);
    if (squaredDistance(p, q) >= shortest) continue;
    shortest = squaredDistance(p, q);
    a = p, b = q;
  }
  const Point middle = midpoint(a, b);
  const double farthest = kHeight * std::sqrt(shortest), far = distance(middle, centre);
  return far > farthest ? middle + (farthest / far) * (centre - middle) : centre;
}

bool atCentre(const MeshState& state, Slot slot, const Circumcircle& circle, double squaredLimit, Slot other,
              Proposal& proposal) {
  const bool off = state.settings.placement == Placement::off_centre;
  proposal.at = off ? offCentre(state.mesh, slot, circle.centre) : circle.centre;
  proposal.measured = std::sqrt(circle.squaredRadius);
  proposal.limit = std::sqrt(squaredLimit);
  proposal.other = other;
  return true;
}

// Step 1: R ≥ h at the circumcentre. The tree is asked last: most circles are smaller than any h.
bool step1(const MeshState& state, Slot slot, LeafPath& path, Proposal& proposal) {
  const Circumcircle circle = circleOf(state.mesh, slot);
  if (!notBelow(circle.squaredRadius, squared(state.tree.minEdge))) return false;
  const double limit = squared(edgeLengthAt(state.tree, circle.centre, path));
  return notBelow(circle.squaredRadius, limit) && atCentre(state, slot, circle, limit, {}, proposal);
}

// Step 2: R ≥ the least h over the three apexes.
double leastEdgeLength(const MeshState& state, const Triangle& t) {
  const Per<Vertex, std::uint8_t>& rank = state.mesh.density;
  return edgeLengthOf(state.tree, std::min({rank[t.v[0]], rank[t.v[1]], rank[t.v[2]]}));
}
bool step2(const MeshState& state, Slot slot, Proposal& proposal) {
  const Circumcircle circle = circleOf(state.mesh, slot);
  const double limit = squared(leastEdgeLength(state, triangleAt(state.mesh, slot)));
  return notBelow(circle.squaredRadius, limit) && atCentre(state, slot, circle, limit, {}, proposal);
}

// Step 3: R ≥ e. Bounds the edge ratio, the angles and the aspect ratio (Theorem 1).
bool step3(const MeshState& state, Slot slot, Proposal& proposal) {
  const Circumcircle circle = circleOf(state.mesh, slot);
  const double limit = squaredShortestEdge(state.mesh, slot);
  return notBelow(circle.squaredRadius, limit) && atCentre(state, slot, circle, limit, {}, proposal);
}

// Step 4: R ≥ e of an adjacent triangle. Not as the paper says, it passes by a pair whose areas are close already:
// along a row of nearly equilateral triangles each insertion would call for the next, against the density asked for.
bool step4(const MeshState& state, Slot slot, Proposal& proposal) {
  const Circumcircle circle = circleOf(state.mesh, slot);
  const double own = twiceArea(state.mesh, slot);
  for (const Half across : triangleAt(state.mesh, slot).adj) {
    if (!across.exists()) continue;
    if (own < state.settings.step4AreaRatio * twiceArea(state.mesh, triangleOf(across))) continue;
    const double limit = squaredShortestEdge(state.mesh, triangleOf(across));
    if (notBelow(circle.squaredRadius, limit))
      return atCentre(state, slot, circle, limit, triangleOf(across), proposal);
  }
  return false;
}

// Step 5: over the edge p1p3 shared with an adjacent triangle of height h and shortest edge e, this triangle's apex p4
// is at least e + h from the edge's midpoint p5. Bounds the area ratio (Theorem 2).
bool step5(const MeshState& state, Slot slot, Proposal& proposal) {
  const Mesh& mesh = state.mesh;
  for (int i = 0; i < 3; ++i) {
    const Half half = halfOf(slot, i);
    const Half across = oppositeOf(mesh, half);
    if (!across.exists()) continue;
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

bool proposes(Stage step, const MeshState& state, Slot slot, LeafPath& path, Proposal& proposal) {
  switch (step) {
    case Stage::step1:
      return step1(state, slot, path, proposal);
    case Stage::step2:
      return step2(state, slot, proposal);
    case Stage::step3:
      return step3(state, slot, proposal);
    case Stage::step4:
      return step4(state, slot, proposal);
    default:
      return step5(state, slot, proposal);
  }
}

Quiet clearlyQuiet(const MeshState& state, Slot slot) {
  constexpr double kClearly = 1.0 - 1e-6;  // far from a tie, whatever the order of the operations
  const Mesh& mesh = state.mesh;
  const Point* const points = mesh.points.data();
  const Triangle* const all = mesh.triangles.data();
  const Triangle& t = all[slot.n];
  const std::array<Point, 3> corners{points[t.v[0].n], points[t.v[1].n], points[t.v[2].n]};
  const std::array<Point, 3> along{corners[2] - corners[1], corners[0] - corners[2], corners[1] - corners[0]};
  const std::array<double, 3> edges{squaredLength(along[0]), squaredLength(along[1]), squaredLength(along[2])};
  const double sum = edges[0] + edges[1] + edges[2];
  const double own = cross(along[2], along[0]);
  // R² = radius / area², so that R² < x is radius < area² x.
  const double radius = edges[0] * edges[1] * edges[2];
  const double area = 4.0 * kClearly * own * own;
  const double ratio = kClearly * state.settings.step4AreaRatio;
  Quiet quiet;
  quiet.step2 = radius < area * squared(leastEdgeLength(state, t));
  quiet.step3 = radius < area * std::min({edges[0], edges[1], edges[2]});
  quiet.bounds = quiet.step3;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!t.adj[i].exists()) continue;
    const auto across = t.adj[i].word();
    const std::uint32_t beyond = across / 3u;
    const Point apex = points[all[beyond].v[across - 3u * beyond].n];
    const Point toApex = apex - corners[i == 2 ? 0 : i + 1];
    const double edge = edges[i];
    const double other = cross(toApex, along[i]);
    const double shortest = std::min({squaredLength(toApex), squaredLength(toApex - along[i]), edge});
    // Not one condition after the other: as good as none of them can be foreseen.
    quiet.bounds = quiet.bounds & (std::max(own, other) < 3.0 * kClearly * std::min(own, other));
    quiet.step4 = quiet.step4 & ((own < ratio * other) | (radius < area * shortest));
    // The squared median, from the middle of the edge to the corner opposite, rounded up; h = other / |p1 p3|. Few need
    // a root: 2 e h is at least 2 e² other / |p1 p3|².
    const double reach = 0.25 * (2.0 * sum - 3.0 * edge) + 1e-9 * sum;
    if (reach * edge < kClearly * kClearly * (shortest * edge + other * other + 2.0 * shortest * other)) continue;
    if (!(std::sqrt(reach * edge) < kClearly * (std::sqrt(shortest * edge) + other))) quiet.step5 = false;
  }
  return quiet;
}

}  // namespace triscope
