// Stage "carve" (paper, section 3, Figure 4 b): triangles outside the domain are removed, one per decision.
#include "core/base/assert.h"
#include "core/domain/loop_of.h"
#include "core/mesh/centroid.h"
#include "core/mesh/edit.h"
#include "core/method/stages/stage_runs.h"

namespace triscope {
namespace {

// Marks the boundary edges constrained, and lists the triangles outside: those that can be reached from the right of a
// loop's edge, or from the box around everything, without crossing a boundary edge.
void findOutside(MeshState& state) {
  Mesh& mesh = state.mesh;
  std::vector<Slot>& outside = state.cursor.of<SlotsAhead>().slots;
  Per<Slot, std::uint8_t> seen(mesh.triangles.size(), 0);
  const auto reach = [&](Slot slot) {
    if (seen[slot] != 0) return;
    seen[slot] = 1;
    outside.push_back(slot);
  };
  for (const BoundaryEdge& edge : mesh.edges) {
    const Half inside = findHalfEdge(mesh, edge.v0, edge.v1);
    TRISCOPE_CHECK(inside.exists() && oppositeOf(mesh, inside).exists(),
                   "after the recovery no boundary edge is missing");
    const Half across = oppositeOf(mesh, inside);
    constrain(mesh, inside);
    constrain(mesh, across);
  }
  for (int helper = 0; helper < 4; ++helper) reach(mesh.vertexTriangle[Vertex(helper)]);
  for (const BoundaryEdge& edge : mesh.edges) {
    if (loopOf(*state.domain, edge.curve).role == LoopRole::chain) continue;
    reach(triangleOf(findHalfEdge(mesh, edge.v1, edge.v0)));
  }
  for (std::size_t k = 0; k < outside.size(); ++k) {
    for (int i = 0; i < 3; ++i) {
      const Half half = halfOf(outside[k], i);
      const Half across = oppositeOf(mesh, half);
      if (across.exists() && !constrained(mesh, half)) reach(triangleOf(across));
    }
  }
  for (const Slot slot : mesh.triangles.keys()) {
    if (seen[slot] != 0 || !mesh.alive(slot)) continue;
    for (const Vertex v : mesh.triangles[slot].v) mesh.vertexTriangle[v] = slot;
    mesh.lastTriangle = slot;
  }
}

}  // namespace

Outcome runCarve(MeshState& state, Journal& journal) {
  Cursor& cursor = state.cursor;
  Mesh& mesh = state.mesh;
  if (!cursor.begun) {
    cursor.begun = true;
    findOutside(state);
  }
  const std::vector<Slot>& outside = cursor.of<SlotsAhead>().slots;
  if (cursor.index == outside.size()) {
    for (int helper = 0; helper < 4; ++helper) {
      mesh.kinds[Vertex(helper)] = VertexKind::removed;
      mesh.vertexTriangle[Vertex(helper)] = {};
    }
    return Outcome::done;
  }
  const Slot slot = outside[cursor.index++];
  if (journal.listening()) {
    Event event = eventIn(state, EventKind::triangle_removed, Rule::carve);
    event.subject = idOf(mesh, slot).n;
    event.removedCount = 1;
    event.at = centroidOf(mesh, slot);
    journal.record(event);
  }
  for (int i = 0; i < 3; ++i) {
    const Half across = oppositeOf(mesh, halfOf(slot, i));
    if (across.exists()) mesh.triangles[triangleOf(across)].adj[cornerOf(across)] = {};
  }
  killTriangle(mesh, slot);
  return Outcome::decided;
}

}  // namespace triscope
