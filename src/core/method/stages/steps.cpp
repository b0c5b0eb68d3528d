// Stages "step1" … "step5" (paper, section 3.1): triangles are looked at until the rule proposes no further point.
// New triangles are looked at next, so that insertions stay close to the last one.
#include <algorithm>

#include "core/mesh/edit.h"
#include "core/mesh/tested.h"
#include "core/method/stages/insertion_rules.h"
#include "core/method/stages/limits.h"
#include "core/method/stages/place.h"
#include "core/method/stages/stage_runs.h"

namespace triscope {
namespace {

Rule ruleOf(Stage step) {
  return static_cast<Rule>(static_cast<int>(Rule::step1) + static_cast<int>(step) - static_cast<int>(Stage::step1));
}

constexpr std::uint8_t bitOf(Stage step) {
  return static_cast<std::uint8_t>(1u << (static_cast<int>(step) - static_cast<int>(Stage::step1)));
}

// Marks what the later steps need not look at again, while the triangle and its neighbours are at hand: reading the
// whole mesh once more for each rule costs more than the rules do. Not in step 1, most triangles of which are soon
// gone.
void passOver(MeshState& state, Slot slot, const Quiet& quiet) {
  std::uint8_t& tested = state.mesh.tested[slot];
  if (quiet.step3) tested |= bitOf(Stage::step3);
  if (quiet.step4) tested |= bitOf(Stage::step4);
  if (quiet.step5) tested |= bitOf(Stage::step5);
  if (quiet.bounds) tested |= kTestedRepair;
}

// In the order of the star of the new vertex, which begins at the last triangle made.
void queueFan(std::vector<Slot>& ahead, std::span<const Slot> fan) {
  ahead.push_back(fan.back());
  ahead.insert(ahead.end(), fan.begin(), fan.end() - 1);
}

Attempt insert(MeshState& state, Slot slot, const Proposal& proposal, Placing& placing) {
  if (state.mesh.points.size() < mostVertices(state)) {
    const double nearest = std::max(proposal.nearest, shortestMade(state));
    return place(state.mesh, state.tree, proposal.at, slot, VertexKind::steiner, {nearest, -0.5}, placing);
  }
  state.cursor.of<SlotsAhead>().slots.clear();  // the rest of the stage is left undone
  Attempt attempt;
  attempt.refusal = Refusal::budget_spent;
  return attempt;
}

void record(const MeshState& state, Journal& journal, TriangleId subject, const Proposal& proposal, TriangleId other,
            const Attempt& attempt) {
  if (!journal.listening()) return;
  Event event = eventIn(state, attempt.vertex.exists() ? EventKind::vertex_inserted : EventKind::vertex_refused,
                        ruleOf(state.stage));
  event.subject = subject.n;
  event.other = other.n;
  event.at = proposal.at;
  describeAttempt(event, attempt);
  event.measured = proposal.measured;
  event.limit = proposal.limit;
  journal.record(event);
}

}  // namespace

Outcome runSteps(MeshState& state, Journal& journal) {
  Cursor& cursor = state.cursor;
  Mesh& mesh = state.mesh;
  std::vector<Slot>& ahead = cursor.of<SlotsAhead>().slots;
  const std::uint8_t bit = bitOf(state.stage);
  if (!cursor.begun) {
    cursor.begun = true;
    forEachUntested(mesh, bit, [&](Slot slot) { ahead.push_back(slot); });
  }
  while (!ahead.empty()) {
    const Slot slot = ahead.back();
    ahead.pop_back();
    if ((mesh.flags[slot] & (kDead | kFillsGap)) != 0 || (mesh.tested[slot] & bit) != 0) continue;
    mesh.tested[slot] |= bit;
    Proposal proposal;
    if (state.stage == Stage::step1) {
      if (!proposes(state.stage, state, slot, state.room.placing.path, proposal)) continue;
    } else {
      const Quiet quiet = clearlyQuiet(state, slot);
      if (quiet.of(state.stage) || !proposes(state.stage, state, slot, state.room.placing.path, proposal)) {
        passOver(state, slot, quiet);
        continue;
      }
    }
    const TriangleId subject = idOf(mesh, slot);
    const TriangleId other = proposal.other.exists() ? idOf(mesh, proposal.other) : TriangleId();
    const Attempt attempt = insert(state, slot, proposal, state.room.placing);
    record(state, journal, subject, proposal, other, attempt);
    if (!attempt.vertex.exists()) {
      ++state.counts[state.stage].refused;
      return Outcome::decided;
    }
    queueFan(ahead, state.room.placing.cavity.fan());
    return Outcome::inserted;
  }
  return Outcome::done;
}

}  // namespace triscope
