// Stage "repair", our own: what steps 1-5 had to refuse near the boundary can leave a bound of section 3 broken. For
// each such triangle a few edits around it are tried on a small copy of the mesh (a vertex moved, put in, taken out, a
// boundary edge split), and the one that mends most is made. Another round of steps 2-5 follows.
#include <algorithm>
#include <array>

#include "core/mesh/badness.h"
#include "core/mesh/edit.h"
#include "core/mesh/tested.h"
#include "core/method/stages/limits.h"
#include "core/method/stages/stage_runs.h"
#include "core/method/stages/treatment.h"

namespace triscope {
namespace {

constexpr int kPasses = 8;  // over the triangles that break a bound, in one visit of the stage

// Slots of the triangles around a vertex: of those, too, that fill its gap once it is taken out.
void appendStar(const Mesh& mesh, Vertex vertex, std::vector<Slot>& slots) {
  Star star;
  starOf(mesh, vertex, star);
  for (const Half rim : star.rim) slots.push_back(triangleOf(rim));
}

void setFillsGap(Mesh& mesh, Slot slot, bool on) {
  std::uint8_t& flags = mesh.flags[slot];
  flags = static_cast<std::uint8_t>(on ? flags | kFillsGap : flags & ~kFillsGap);
}

void record(const MeshState& state, Journal& journal, const Remedy& remedy, TriangleId subject, Point from,
            const Attempt& attempt) {
  if (!journal.listening()) return;
  constexpr std::array<EventKind, 5> kinds = {EventKind::vertex_refused, EventKind::vertex_moved,
                                              EventKind::vertex_inserted, EventKind::vertex_removed,
                                              EventKind::edge_split};
  Event event = eventIn(state, kinds[static_cast<std::size_t>(remedy.edit)], Rule::repair);
  event.subject = subject.n;
  event.at = remedy.to;
  event.from = from;
  describeAttempt(event, attempt);
  if (remedy.edit == MeshEdit::move || remedy.edit == MeshEdit::remove) event.vertex = remedy.vertex.word();
  if (remedy.edit == MeshEdit::split) {
    event.subject = remedy.edge.word();
    event.other = subject.n;
    if (attempt.vertex.exists()) event.at = pointOf(state.mesh, attempt.vertex);  // on the curve, not on the chord
  }
  if (attempt.createdCount > 0) {
    event.created = attempt.firstId.n;
    event.createdCount = attempt.createdCount;
  }
  journal.record(event);
}

void queueBroken(MeshState& state) {
  Mesh& mesh = state.mesh;
  std::vector<Slot>& ahead = state.cursor.of<SlotsAhead>().slots;
  forEachUntested(mesh, kTestedRepair, [&](Slot slot) {
    if (breaksBound(mesh, slot)) {
      ahead.push_back(slot);
    } else {
      mesh.tested[slot] |= kTestedRepair;
    }
  });
  std::reverse(ahead.begin(), ahead.end());
}

}  // namespace

Outcome runRepair(MeshState& state, Journal& journal) {
  // phase: passes begun; index: changes made in this pass.
  Cursor& cursor = state.cursor;
  Mesh& mesh = state.mesh;
  cursor.begun = true;
  std::vector<Slot>& ahead = cursor.of<SlotsAhead>().slots;
  for (;;) {
    if (ahead.empty()) {
      if (cursor.phase == kPasses || (cursor.phase > 0 && cursor.index == 0)) return Outcome::done;
      ++cursor.phase;
      cursor.index = 0;
      queueBroken(state);
      if (ahead.empty()) return Outcome::done;
    }
    const Slot slot = ahead.back();
    ahead.pop_back();
    if (!mesh.alive(slot) || (mesh.tested[slot] & kTestedRepair) != 0 || !breaksBound(mesh, slot)) continue;
    const TriangleId subject = idOf(mesh, slot);
    StageCounts& counts = state.counts[state.stage];
    if (counts.decisions >= mostRepairs(state)) {
      ahead.clear();
      cursor.phase = kPasses;  // what is left stays as it is
      ++counts.refused;
      Attempt spent;
      spent.refusal = Refusal::budget_spent;
      record(state, journal, {MeshEdit::none, centroidOf(mesh, slot), {}, {}}, subject, {}, spent);
      return Outcome::decided;
    }
    double floor = 0.0;
    const Treatment treatment = bestTreatment(state, slot, floor, state.room);
    if (treatment[0].edit == MeshEdit::none) {
      mesh.tested[slot] |= kTestedRepair;
      ++counts.refused;
      Attempt nothing;
      nothing.refusal = Refusal::bound_broken;
      record(state, journal, {MeshEdit::none, centroidOf(mesh, slot), {}, {}}, subject, {}, nothing);
      return Outcome::decided;
    }
    ++cursor.index;
    bool inserted = false;
    std::vector<Slot> gaps, moved;
    const TriangleId firstId = mesh.nextId;
    for (const Remedy& remedy : treatment) {
      if (remedy.edit == MeshEdit::none) break;
      const Point from = remedy.edit == MeshEdit::move ? pointOf(mesh, remedy.vertex) : remedy.to;
      if (remedy.edit == MeshEdit::remove) appendStar(mesh, remedy.vertex, gaps);
      const Slot start = mesh.alive(slot) ? slot : mesh.lastTriangle;
      const Attempt attempt = applyRemedy(mesh, state, remedy, start, floor, state.room);
      record(state, journal, remedy, subject, from, attempt);
      if (remedy.edit == MeshEdit::move) {
        ++counts.moved;
        moved.clear();
        appendStar(mesh, remedy.vertex, moved);
        for (const Slot other : moved) setFillsGap(mesh, other, false);  // its shape is another now
      }
      if (remedy.edit == MeshEdit::remove) ++counts.removed;
      inserted = inserted || remedy.edit == MeshEdit::insert || remedy.edit == MeshEdit::split;
    }
    // The steps would put back what was taken out, round after round: they pass over what fills its place.
    for (const Slot gap : gaps) {
      if (mesh.alive(gap) && idOf(mesh, gap) >= firstId) setFillsGap(mesh, gap, true);
    }
    if (inserted) return Outcome::inserted;
    ++cursor.changes;
    return Outcome::decided;
  }
}

}  // namespace triscope
