#include "core/method/stages/row_placement.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/circumcircle.h"
#include "core/geometry/trig.h"
#include "core/mesh/edit.h"

namespace triscope {
namespace {

constexpr double kOwnPart = 0.5;  // of the length beside it that a new point takes over
constexpr double kGrowth = 1.2;   // from a row to the next
constexpr double kSixty = 60.0 * trig::kDegree;
constexpr double kHalfTurn = 0.5;  // of the way from 60° to equal parts that a spoke is turned
constexpr double kLowest = 0.3;    // height over the front edge, of the edge length in force
constexpr double kInverseRoot3 = 0.57735026918962576;
constexpr int kMostTriangles = 300;  // around an end of the front edge

struct FrontSpoke {
  Point tip;
  bool closes;
};

struct Base {
  Half half;
  double squaredLength = 1e300;
};

Base shortestFrontEdge(const Mesh& mesh, const RowFront& front, Slot slot) {
  Base base;
  for (const Half half : halvesOf(slot)) {
    if (!front.has(half)) continue;
    const double squared = squaredDistance(pointOf(mesh, startOf(mesh, half)), pointOf(mesh, endOf(mesh, half)));
    if (squared < base.squaredLength) base = {half, squared};
  }
  return base;
}

// From one end of the base edge: the front turns by some angle to its next edge, n triangles of about 60° fit there,
// and the spoke makes an angle between an nth of it and 60° with the base edge.
FrontSpoke spokeFrom(const Mesh& mesh, const RowFront& front, Half base, bool fromStart, double size) {
  const Vertex hub = fromStart ? startOf(mesh, base) : endOf(mesh, base);
  const Point at = pointOf(mesh, hub), other = pointOf(mesh, fromStart ? endOf(mesh, base) : startOf(mesh, base));
  Half side = base;
  for (int turn = 0; turn < kMostTriangles; ++turn) {
    const int corner = cornerOf(side);
    side = halfOf(triangleOf(side), fromStart ? prev3(corner) : next3(corner));
    if (front.has(side)) break;
    side = oppositeOf(mesh, side);
  }
  const Point last = pointOf(mesh, startOf(mesh, side) == hub ? endOf(mesh, side) : startOf(mesh, side));
  double angle = fromStart ? trig::angleBetween(other - at, last - at) : trig::angleBetween(last - at, other - at);
  if (angle <= 1e-9) angle += 2.0 * trig::kPi;
  const int fits = static_cast<int>(std::floor(angle / kSixty + 0.5));
  if (fits <= 1) return {last, true};
  const trig::SinCos turn = trig::sinCos(kSixty + kHalfTurn * (angle / fits - kSixty));
  const Point along = (1.0 / distance(at, other)) * (other - at);
  const double sine = fromStart ? turn.sin : -turn.sin;
  return {at + size * Point{along.x * turn.cos - along.y * sine, along.x * sine + along.y * turn.cos}, false};
}

// How high over the base edge the other rules put the point: where its triangle has the circumradius of an equilateral
// one (S. Rebay, 1993), or where its sides have the length in force (after D. Engwirda, 2014).
double heightOf(Placement placement, double size, double halfBase) {
  if (placement == Placement::rebay) {
    const double radius = std::max(size * kInverseRoot3, halfBase);
    return radius + std::sqrt(radius * radius - halfBase * halfBase);
  }
  const double side = std::max(size, 1.2 * halfBase);
  return std::sqrt(side * side - halfBase * halfBase);
}

}  // namespace

bool isSmall(const MeshState& state, Slot slot, double factor) {
  const Mesh& mesh = state.mesh;
  const Triangle& t = triangleAt(mesh, slot);
  const double size = (state.sizes[t.v[0]] + state.sizes[t.v[1]] + state.sizes[t.v[2]]) / 3.0;
  const double limit = factor * size;
  return 3.0 * squaredCircumradius(pointOf(mesh, t.v[0]), pointOf(mesh, t.v[1]), pointOf(mesh, t.v[2])) <=
         limit * limit;
}

double blendedSize(double asked, double beside) {
  return std::clamp((1.0 - kOwnPart) * asked + kOwnPart * beside, beside / kGrowth, beside * kGrowth);
}

std::optional<RowProposal> proposeRow(const MeshState& state, const RowFront& front, Slot slot, LeafPath& path) {
  const Mesh& mesh = state.mesh;
  const Base base = shortestFrontEdge(mesh, front, slot);
  if (!base.half.exists()) return std::nullopt;
  const Vertex from = startOf(mesh, base.half), to = endOf(mesh, base.half);
  const Point a = pointOf(mesh, from), b = pointOf(mesh, to), middle = midpoint(a, b);
  const Triangle& t = triangleAt(mesh, slot);
  const Point centre = circumcentre(pointOf(mesh, t.v[0]), pointOf(mesh, t.v[1]), pointOf(mesh, t.v[2]));
  RowProposal proposal;
  proposal.base = std::sqrt(base.squaredLength);
  const Point inward = (1.0 / proposal.base) * perpendicular(b - a);
  // That of the ends first, and then what is asked for where the point will be about.
  const double beside = 0.5 * (state.sizes[from] + state.sizes[to]);
  const Placement placement = state.settings.placement;
  const double about = heightOf(placement, beside, 0.5 * proposal.base);
  proposal.size = blendedSize(edgeLengthAt(state.tree, middle + about * inward, path), beside);
  if (placement == Placement::spokes || placement == Placement::tiling) {
    const FrontSpoke left = spokeFrom(mesh, front, base.half, true, proposal.size);
    const FrontSpoke right = spokeFrom(mesh, front, base.half, false, proposal.size);
    proposal.closes = left.closes || right.closes;
    proposal.at = midpoint(left.tip, right.tip);
    const bool inside = squaredDistance(proposal.at, centre) < squaredDistance(a, centre);
    proposal.misses = !inside || !(cross(b - a, proposal.at - a) > kLowest * proposal.base * proposal.size);
    return proposal;
  }
  const double reach = dot(centre - middle, inward);
  proposal.at = middle + std::min(heightOf(placement, proposal.size, 0.5 * proposal.base), reach) * inward;
  proposal.misses = !(reach > 0.0);
  return proposal;
}

}  // namespace triscope
