// Stage "constraints" (paper, Figure 1 a): what asks for which edge length, one decision per wish.
#include "core/density/sources.h"
#include "core/stages/stage_runs.h"

namespace triscope {

Outcome runConstraints(MeshState& state, Journal& journal) {
  Cursor& cursor = state.cursor;
  if (!cursor.begun) {
    cursor.begun = true;
    state.constraints = findConstraints(*state.domain, state.settings, state.minEdge);
    state.tree = rootOver(state.domain->bounds, finestLength(*state.domain, state.minEdge));
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
