#include "core/method/stages/place.h"

#include <algorithm>

#include "core/mesh/badness.h"
#include "core/mesh/edit.h"
#include "core/mesh/flip.h"

namespace triscope {
namespace {

// True when p sees the edge a-b under an angle whose cosine is below `limit`. A tie counts (but for a right angle): the
// centre of an equilateral triangle sees its edges under 120°, where the bound on angles is strict.
bool seenTooWide(Point p, Point a, Point b, double limit) {
  const Point u = a - p;
  const Point v = b - p;
  const double product = dot(u, v);
  if (limit == 0.0) return product < 0.0;
  if (product >= 0.0) return false;
  return product * product > (1.0 - kBoundMargin) * limit * limit * squaredLength(u) * squaredLength(v);
}

// The first constrained half-edge of the rim that the point sees under too wide an angle, if any.
Half encroached(const Mesh& mesh, const Cavity& cavity, double sightCosine) {
  if (!cavity.walled) return {};
  for (const Cavity::RimEdge& edge : cavity.rim()) {
    if (!edge.isWall() || !constrained(mesh, edge.wall())) continue;
    const Point a = pointOf(mesh, startOf(mesh, edge.wall())), b = pointOf(mesh, endOf(mesh, edge.wall()));
    if (seenTooWide(cavity.at, a, b, sightCosine)) return edge.wall();
  }
  return {};
}

}  // namespace

Attempt place(Mesh& mesh, const Quadtree& tree, Point p, Slot start, VertexKind kind, const Demand& demand,
              Placing& placing) {
  Attempt attempt;
  Cavity& cavity = placing.cavity;
  const Location location = walkTo(mesh, start, p);
  if (location.blocked.exists()) {
    attempt.refusal = Refusal::outside_domain;
    attempt.wall = location.blocked;
    return attempt;
  }
  findCavity(mesh, p, location.triangle, cavity);
  attempt.wall = encroached(mesh, cavity, demand.sightCosine);
  if (attempt.wall.exists()) {
    attempt.refusal = Refusal::encroaches_boundary;
    return attempt;
  }
  const double nearest = cavity.nearest;
  if (nearest <= 0.0 || nearest < demand.nearest * demand.nearest) {
    attempt.refusal = Refusal::too_close;
    attempt.measured = std::sqrt(nearest);
    attempt.limit = demand.nearest;
    return attempt;
  }
  attempt.firstId = mesh.nextId;
  attempt.removedCount = static_cast<std::uint32_t>(cavity.triangleCount);
  attempt.vertex = fillCavity(mesh, cavity, kind, static_cast<std::uint8_t>(densityRankAt(tree, p, placing.path)));
  attempt.createdCount = mesh.nextId.n - attempt.firstId.n;
  return attempt;
}

Attempt splitBoundary(Mesh& mesh, const Domain& domain, const Quadtree& tree, EdgeId edge, double minEdge,
                      Placing& placing) {
  Attempt attempt;
  const BoundaryEdge old = mesh.edges[edge];
  const double t = 0.5 * (old.t0 + old.t1);
  const Point p = pointAt(domain.curves[old.curve], t);
  const double half =
      std::sqrt(std::min(squaredDistance(pointOf(mesh, old.v0), p), squaredDistance(pointOf(mesh, old.v1), p)));
  if (half < minEdge * (1.0 - 1e-9)) {
    attempt.refusal = Refusal::edge_below_minimum;
    attempt.measured = half;
    attempt.limit = minEdge;
    return attempt;
  }
  Cavity& cavity = placing.cavity;
  const Half side = edgeBetween(mesh, old.v0, old.v1);
  if (!side.exists() || !findSplitCavity(mesh, p, side, cavity)) {
    attempt.refusal = Refusal::inverts_triangle;
    return attempt;
  }
  attempt.firstId = mesh.nextId;
  attempt.removedCount = static_cast<std::uint32_t>(cavity.triangleCount);
  attempt.vertex =
      fillSplitCavity(mesh, cavity, edge, t, static_cast<std::uint8_t>(densityRankAt(tree, p, placing.path)));
  // A point on a bent curve lies off its chord, where the cavity's argument for the Delaunay property does not hold.
  starOf(mesh, attempt.vertex, placing.star);
  placing.suspects.assign(placing.star.rim.begin(), placing.star.rim.end());
  placing.flips.clear();
  restoreDelaunay(mesh, placing.suspects, placing.flips, mostFlips(mesh));
  attempt.createdCount = mesh.nextId.n - attempt.firstId.n;
  return attempt;
}

void describeAttempt(Event& event, const Attempt& attempt) {
  event.refusal = attempt.refusal;
  if (attempt.vertex.exists()) {
    event.vertex = attempt.vertex.word();
    event.created = attempt.firstId.n;
    event.createdCount = attempt.createdCount;
    event.removedCount = static_cast<std::uint16_t>(attempt.removedCount);
  } else {
    event.measured = attempt.measured;
    event.limit = attempt.limit;
  }
}

}  // namespace triscope
