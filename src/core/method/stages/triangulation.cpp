// Stage "triangulation" (paper, section 3, Figure 4 b): the boundary points by Bowyer-Watson.
#include <algorithm>

#include "core/mesh/edit.h"
#include "core/method/stages/place.h"
#include "core/method/stages/placing_order.h"
#include "core/method/stages/stage_runs.h"

namespace triscope {
namespace {

constexpr std::size_t kInLoopOrder = 256;  // points at most that are placed in the order of the loops

// Room for the mesh to come, so that growing it does not copy it again and again.
void reserve(Mesh& mesh, double triangles) {
  const auto count = static_cast<std::size_t>(std::min(1.2 * triangles, 2e7));
  mesh.points.reserve(count / 2);
  mesh.kinds.reserve(count / 2);
  mesh.density.reserve(count / 2);
  mesh.vertexTriangle.reserve(count / 2);
  mesh.vertexEdge.reserve(count / 2);
  mesh.triangles.reserve(count);
  mesh.ids.reserve(count);
  mesh.flags.reserve(count);
  mesh.tested.reserve(count);
}

// Two triangles over a square far around the root: every boundary point falls inside.
void boxAround(MeshState& state) {
  Mesh& mesh = state.mesh;
  const double side = state.tree.side(state.tree.cells[0]);
  const Point lo = state.tree.origin - Point{3.0 * side, 3.0 * side};
  const Point hi = state.tree.origin + Point{4.0 * side, 4.0 * side};
  for (const Point corner : {lo, Point{hi.x, lo.y}, hi, Point{lo.x, hi.y}})
    addVertex(mesh, corner, VertexKind::helper, 0);
  const Slot lower = addTriangle(mesh, Vertex(0), Vertex(1), Vertex(2));
  const Slot upper = addTriangle(mesh, Vertex(0), Vertex(2), Vertex(3));
  link(mesh, halfOf(lower, 1), halfOf(upper, 2));
}

void addBoundaryEdges(MeshState& state) {
  for (std::size_t k = 0; k + 1 < state.boundary.size(); ++k) {
    const BoundaryPoint& a = state.boundary[k];
    const BoundaryPoint& b = state.boundary[k + 1];
    if (a.curve != b.curve) continue;
    addBoundaryEdge(state.mesh, {a.vertex, b.vertex, a.curve, {}, {}, a.t, b.t});
  }
}

// Vertex of the closed triangle `slot` at p, or none.
Vertex vertexAt(const Mesh& mesh, Slot slot, Point p) {
  for (const Vertex v : triangleAt(mesh, slot).v) {
    if (pointOf(mesh, v) == p) return v;
  }
  return {};
}

}  // namespace

Outcome runTriangulation(MeshState& state, Journal& journal) {
  Cursor& cursor = state.cursor;
  Mesh& mesh = state.mesh;
  if (!cursor.begun) {
    cursor.begun = true;
    reserve(mesh, state.estimatedTriangles);
    boxAround(state);
    cursor.of<BoundaryOrder>().points = placingOrder(state.boundary.size(), kInLoopOrder);
  }
  const std::vector<std::int32_t>& order = cursor.of<BoundaryOrder>().points;
  for (; cursor.index < state.boundary.size(); ++cursor.index) {
    BoundaryPoint& point = state.boundary[static_cast<std::size_t>(order[cursor.index])];
    const Vertex near = vertexAt(mesh, walkTo(mesh, mesh.lastTriangle, point.at).triangle, point.at);
    if (near.exists()) {  // curves share their ends
      point.vertex = near;
      continue;
    }
    const Attempt attempt = place(mesh, state.tree, point.at, mesh.lastTriangle,
                                  point.kept ? VertexKind::kept : VertexKind::boundary, {}, state.room.placing);
    point.vertex = attempt.vertex;
    if (journal.listening()) {
      Event event = eventIn(state, EventKind::vertex_inserted, Rule::initial);
      event.other = point.curve;
      event.at = point.at;
      describeAttempt(event, attempt);
      journal.record(event);
    }
    ++cursor.index;
    return Outcome::inserted;
  }
  addBoundaryEdges(state);
  return Outcome::done;
}

}  // namespace triscope
