// Stage "recovery" (paper, section 3, Figure 4 b): every boundary edge is made present by splitting the missing ones on
// their curves.
#include <algorithm>
#include <cmath>

#include "core/mesh/edit.h"
#include "core/method/stages/limits.h"
#include "core/method/stages/place.h"
#include "core/method/stages/stage_runs.h"

namespace triscope {
namespace {

bool kept(const Mesh& mesh, Vertex vertex) { return mesh.kinds[vertex] == VertexKind::kept; }

// Parameter of the edge's point that is `reach` away from its end at `from`, by halving; distances grow along an edge.
double reaching(const Curve& curve, double from, double to, double reach) {
  const Point origin = pointAt(curve, from);
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (from + to);
    (distance(origin, pointAt(curve, middle)) < reach ? from : to) = middle;
  }
  return 0.5 * (from + to);
}

// Where to split: half-way; but an edge with one end at a kept point, where curves may meet at a sharp angle, at Δx
// times a power of two from there. All edges at the point are split at the same distances then, and do not call for
// one another's splits for ever (J. Ruppert, 1995: "concentric shells").
double splitAt(const MeshState& state, const BoundaryEdge& edge) {
  const Mesh& mesh = state.mesh;
  const double half = 0.5 * (edge.t0 + edge.t1);
  const bool first = kept(mesh, edge.v0);
  if (first == kept(mesh, edge.v1)) return half;
  const double length = distance(pointOf(mesh, edge.v0), pointOf(mesh, edge.v1));
  double shell = state.minEdge;
  while (shell > length / 1.5) shell *= 0.5;
  while (shell < length / 3.0) shell *= 2.0;
  const Curve& curve = state.domain->curves[edge.curve];
  const double t = first ? reaching(curve, edge.t0, edge.t1, shell) : reaching(curve, edge.t1, edge.t0, shell);
  return t;
}

Outcome giveUp(MeshState& state, Journal& journal, std::uint64_t edge, Point p, const Attempt& attempt) {
  state.failed = true;
  if (journal.listening()) {
    Event event = eventIn(state, EventKind::failure, Rule::recover_edge);
    event.subject = static_cast<std::uint32_t>(edge);
    event.at = p;
    describeAttempt(event, attempt);
    journal.record(event);
  }
  return Outcome::done;
}

}  // namespace

Outcome runRecovery(MeshState& state, Journal& journal) {
  // index: next boundary edge to look at; phase: 1 when this pass split one, so that another pass is due.
  Cursor& cursor = state.cursor;
  Mesh& mesh = state.mesh;
  cursor.begun = true;
  for (;;) {
    for (; cursor.index < mesh.edges.size(); ++cursor.index) {
      const BoundaryEdge edge = mesh.edges[EdgeId(cursor.index)];
      if (findHalfEdge(mesh, edge.v0, edge.v1).exists()) continue;
      const double t = splitAt(state, edge);
      const Point p = pointAt(state.domain->curves[edge.curve], t);
      Attempt attempt;
      if (cursor.changes >= mostSplits(state)) {
        attempt.refusal = Refusal::budget_spent;
        attempt.measured = static_cast<double>(cursor.changes);
        attempt.limit = static_cast<double>(mostSplits(state));
        return giveUp(state, journal, cursor.index, p, attempt);
      }
      attempt =
          place(mesh, state.tree, p, mesh.lastTriangle, VertexKind::split, {shortestMade(state)}, state.room.placing);
      if (!attempt.vertex.exists()) return giveUp(state, journal, cursor.index, p, attempt);
      splitBoundaryEdge(mesh, EdgeId(cursor.index), attempt.vertex, t);
      cursor.phase = 1;
      if (journal.listening()) {
        Event event = eventIn(state, EventKind::edge_split, Rule::recover_edge);
        event.at = p;
        describeAttempt(event, attempt);
        event.subject = static_cast<std::uint32_t>(cursor.index);
        event.measured = distance(pointOf(mesh, edge.v0), pointOf(mesh, edge.v1));
        journal.record(event);
      }
      return Outcome::inserted;
    }
    if (cursor.phase == 0) return Outcome::done;
    cursor.phase = 0;
    cursor.index = 0;
  }
}

}  // namespace triscope
