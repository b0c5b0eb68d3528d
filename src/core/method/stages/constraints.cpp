// Stage "constraints" (paper, Figure 1 a): what asks for which edge length, one decision per wish.
#include "core/density/sources.h"
#include "core/method/stages/split_leaf.h"
#include "core/method/stages/stage_runs.h"
#include "core/method/triangle_limit.h"

namespace triscope {
namespace {

void begin(MeshState& state, Journal& journal) {
  const Domain& domain = *state.domain;
  state.cursor.begun = true;
  state.tree = rootOver(domain.bounds, state.tree.minEdge);
  state.search = searchFor(domain, state.minEdge);
  // A loop with more edges than triangles are allowed is not even looked along.
  const LoopDemand demand = greediestAlong(domain, state.minEdge);
  if (demand.triangles <= state.settings.maxTriangles) return;
  state.search = {};
  state.constraints = {demand.constraint};
  holdToLimit(state, demand.triangles, journal);
}

}  // namespace

Outcome runConstraints(MeshState& state, Journal& journal) {
  Cursor& cursor = state.cursor;
  if (!cursor.begun) begin(state, journal);
  if (state.failed) return Outcome::done;
  if (state.search.part != ConstraintSearch::Part::over) {
    if (carryOn(state.search, *state.domain, state.settings)) return Outcome::worked;
    state.constraints = std::move(state.search.found);
    state.search = {};
  }
  if (cursor.index == state.constraints.size()) return Outcome::done;
  if (journal.listening()) {
    const Constraint& constraint = state.constraints[cursor.index];
    Event event = eventIn(state, EventKind::constraint_found, constraint.source);
    event.subject = static_cast<std::uint32_t>(cursor.index);
    event.other = constraint.curve;
    event.measured = constraint.length;
    event.at = constraint.at;
    journal.record(event);
  }
  ++cursor.index;
  return Outcome::decided;
}

}  // namespace triscope
