// Stage "carve" (paper, section 3, Figure 4 b): triangles outside the domain are removed, one per decision.
#include "core/base/assert.h"
#include "core/domain/loop_of.h"
#include "core/mesh/edit.h"
#include "core/method/stages/stage_runs.h"

namespace triscope {
namespace {

// Marks the boundary edges constrained, and lists the triangles outside: those that can be reached from the right of a
// loop's edge, or from the box around everything, without crossing a boundary edge.
void findOutside(MeshState& state) {
  Mesh& mesh = state.mesh;
  std::vector<std::int32_t>& outside = state.cursor.worklist;
  std::vector<std::uint8_t> seen(mesh.triangles.size(), 0);
  const auto reach = [&](std::int32_t slot) {
    if (seen[at(slot)] != 0) return;
    seen[at(slot)] = 1;
    outside.push_back(slot);
  };
  for (const BoundaryEdge& edge : mesh.edges) {
    const std::int32_t inside = findHalfEdge(mesh, edge.v0, edge.v1);
    TRISCOPE_CHECK(inside >= 0 && oppositeOf(mesh, inside) >= 0, "after the recovery no boundary edge is missing");
    const std::int32_t across = oppositeOf(mesh, inside);
    setConstrained(mesh, inside, true);
    setConstrained(mesh, across, true);
  }
  for (std::int32_t helper = 0; helper < 4; ++helper) reach(mesh.vertexTriangle[at(helper)]);
  for (const BoundaryEdge& edge : mesh.edges) {
    if (loopOf(*state.domain, edge.curve).role == LoopRole::chain) continue;
    reach(triangleOf(findHalfEdge(mesh, edge.v1, edge.v0)));
  }
  for (std::size_t k = 0; k < outside.size(); ++k) {
    for (int i = 0; i < 3; ++i) {
      const std::int32_t half = 3 * outside[k] + i;
      const std::int32_t across = oppositeOf(mesh, half);
      if (across >= 0 && !constrained(mesh, half)) reach(triangleOf(across));
    }
  }
  for (std::size_t slot = 0; slot < mesh.triangles.size(); ++slot) {
    if (seen[slot] != 0 || !mesh.alive(static_cast<std::int32_t>(slot))) continue;
    for (const std::int32_t v : mesh.triangles[slot].v) mesh.vertexTriangle[at(v)] = static_cast<std::int32_t>(slot);
    mesh.lastTriangle = static_cast<std::int32_t>(slot);
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
  if (cursor.index == cursor.worklist.size()) {
    for (std::size_t helper = 0; helper < 4; ++helper) {
      mesh.kinds[helper] = VertexKind::removed;
      mesh.vertexTriangle[helper] = -1;
    }
    return Outcome::done;
  }
  const std::int32_t slot = cursor.worklist[cursor.index++];
  if (journal.listening()) {
    Event event = eventIn(state, EventKind::triangle_removed, Rule::carve);
    event.subject = idOf(mesh, slot);
    event.removedCount = 1;
    const Triangle& t = triangleAt(mesh, slot);
    event.at = (1.0 / 3.0) * (pointOf(mesh, t.v[0]) + pointOf(mesh, t.v[1]) + pointOf(mesh, t.v[2]));
    journal.record(event);
  }
  for (int i = 0; i < 3; ++i) {
    const std::int32_t across = oppositeOf(mesh, 3 * slot + i);
    if (across >= 0) mesh.triangles[at(triangleOf(across))].adj[static_cast<std::size_t>(cornerOf(across))] = -1;
  }
  killTriangle(mesh, slot);
  return Outcome::decided;
}

}  // namespace triscope
