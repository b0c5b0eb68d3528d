#include "core/run/validity.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/domain/loop_of.h"
#include "core/domain/shortest_line.h"
#include "core/geometry/predicates.h"
#include "core/mesh/edit.h"
#include "core/mesh/flip.h"

namespace triscope {
namespace {

constexpr double kAreaTolerance = 1e-9;  // of the area: the sums are plain

std::uint8_t brokenIn(const MeshState& state, Slot slot, double squaredShortest) {
  const Mesh& mesh = state.mesh;
  const Triangle& t = triangleAt(mesh, slot);
  std::uint8_t broken = 0;
  if (orient2d(pointOf(mesh, t.v[0]), pointOf(mesh, t.v[1]), pointOf(mesh, t.v[2])) <= 0) broken |= kOrientation;
  for (int i = 0; i < 3; ++i) {
    const Half half = halfOf(slot, i);
    // The optimiser restores it between its passes.
    if (!optimisesMesh(state.stage) && flipWanted(mesh, half)) broken |= kDelaunay;
    // Edges between points that the input fixes are as long as the input makes them.
    const Vertex a = startOf(mesh, half), b = endOf(mesh, half);
    const bool fixed = mesh.kinds[a] <= VertexKind::kept && mesh.kinds[b] <= VertexKind::kept;
    if (!fixed && squaredDistance(pointOf(mesh, a), pointOf(mesh, b)) < squaredShortest) broken |= kMinimumLength;
    if (state.stage <= Stage::recovery) continue;
    for (EdgeId e = mesh.vertexEdge[a]; e.exists();) {
      const BoundaryEdge& edge = mesh.edges[e];
      if (!edgeBetween(mesh, edge.v0, edge.v1).exists()) broken |= kBoundary;
      e = edge.v0 == a ? edge.next0 : edge.next1;
    }
  }
  return broken;
}

bool balanced(const Quadtree& tree) {
  std::vector<std::int32_t> beside;
  for (std::size_t k = 0; k < tree.cells.size(); ++k) {
    if (tree.cells[k].child >= 0) continue;
    neighboursOf(tree, static_cast<std::int32_t>(k), beside);
    for (const std::int32_t other : beside)
      if (std::abs(tree.cells[static_cast<std::size_t>(other)].rank - tree.cells[k].rank) > 1) return false;
  }
  return true;
}

// The domain lies to the left of its loops; a chain has it on both sides and encloses nothing.
bool fillsTheDomain(const MeshState& state) {
  const Mesh& mesh = state.mesh;
  const Point origin = state.tree.origin;
  double inside = 0.0, filled = 0.0;
  for (const BoundaryEdge& edge : mesh.edges)
    if (exists(edge) && loopOf(*state.domain, edge.curve).role != LoopRole::chain)
      inside += cross(pointOf(mesh, edge.v0) - origin, pointOf(mesh, edge.v1) - origin);
  for (const Slot slot : mesh.triangles.keys())
    if (mesh.alive(slot)) filled += twiceArea(mesh, slot);
  return std::fabs(filled - inside) <= kAreaTolerance * std::fabs(inside);
}

}  // namespace

double shortestInput(const MeshState& state) { return shortestLine(*state.domain).length; }

std::uint8_t brokenRules(const MeshState& state, std::span<const Slot> changed, std::span<const Event> events,
                         double shortestInput) {
  const double shortest = std::min(shortestMeant(state), shortestInput);
  // Before the carving edges may run outside the domain, across a thin part of it.
  // The optimiser holds edges to the lengths that are wanted where they are, not to Δx.
  const bool bound = isCarved(state.stage) && !optimisesMesh(state.stage);
  const double squaredShortest = bound ? shortest * shortest * (1.0 - 1e-9) : 0.0;
  std::uint8_t broken = 0;
  for (const Slot slot : changed)
    if (state.mesh.alive(slot)) broken |= brokenIn(state, slot, squaredShortest);
  for (const Event& event : events) {
    if (event.kind != EventKind::stage_finished) continue;
    if (event.stage == Stage::density && !balanced(state.tree)) broken |= kBalance;
    if (event.stage >= Stage::carve && !fillsTheDomain(state)) broken |= kArea;
  }
  return broken;
}

}  // namespace triscope
