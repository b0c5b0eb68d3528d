// Stage "repair", our own: what steps 1-5 had to refuse near the boundary can leave a bound of section 3 broken. For
// each such triangle a few edits around it are tried on a small copy of the mesh (a vertex moved, put in, taken out, a
// boundary edge split), and the one that mends most is made. Another round of steps 2-5 follows.
#include <algorithm>
#include <array>

#include "core/geometry/circumcircle.h"
#include "core/geometry/trig.h"
#include "core/mesh/badness.h"
#include "core/mesh/change_log.h"
#include "core/mesh/edit.h"
#include "core/mesh/move.h"
#include "core/mesh/patch.h"
#include "core/mesh/remove.h"
#include "core/mesh/tested.h"
#include "core/stages/place.h"
#include "core/stages/stage_runs.h"

namespace triscope {
namespace {

constexpr int kPatchDepth = 7;
constexpr int kPasses = 8;  // over the triangles that break a bound, in one visit of the stage

enum class Edit : std::uint8_t { none, move, insert, remove, split };

struct Remedy {
  Edit edit = Edit::none;
  std::int32_t index = -1;  // vertex (move, remove) or boundary edge (split)
  Point to;
};

// No edit makes an edge shorter than this: Δx, or where the input itself is finer, its finest edge nearby.
double floorAround(const MeshState& state, const Badness& now) {
  return std::min(state.minEdge, std::sqrt(now.shortest) * (1.0 - 1e-9));
}

Attempt apply(Mesh& mesh, const MeshState& state, const Remedy& remedy, std::int32_t start, double floor) {
  thread_local MoveLog log;
  Attempt attempt;
  attempt.refusal = Refusal::inverts_triangle;
  switch (remedy.edit) {
    case Edit::move:
      attempt.firstId = mesh.nextId;
      if (moveVertex(mesh, remedy.index, remedy.to, log)) attempt.refusal = Refusal::none;
      attempt.createdCount = mesh.nextId - attempt.firstId;
      return attempt;
    case Edit::insert:
      return place(mesh, state.tree, remedy.to, start, VertexKind::steiner, {floor, -0.5});
    case Edit::remove:
      attempt.firstId = mesh.nextId;
      if (removeVertex(mesh, remedy.index)) attempt.refusal = Refusal::none;
      attempt.createdCount = mesh.nextId - attempt.firstId;
      return attempt;
    case Edit::split:
      return splitBoundary(mesh, *state.domain, state.tree, remedy.index, floor);
    case Edit::none:
      break;
  }
  return attempt;
}

// Slots around a vertex: those of the triangles that fill its gap once it is taken out.
void appendStar(const Mesh& mesh, std::int32_t vertex, std::vector<std::int32_t>& slots) {
  thread_local Star star;
  starOf(mesh, vertex, star);
  for (const std::int32_t rim : star.rim) slots.push_back(triangleOf(rim));
}

Badness badnessOfAll(const Mesh& mesh) {
  thread_local std::vector<std::int32_t> live;
  live.clear();
  for (std::size_t slot = 0; slot < mesh.triangles.size(); ++slot) {
    if ((mesh.flags[slot] & kDead) == 0) live.push_back(static_cast<std::int32_t>(slot));
  }
  return badnessOf(mesh, live);
}

bool better(const Badness& l, const Badness& r) {
  return l.broken < r.broken || (l.broken == r.broken && l.excess < r.excess * (1.0 - 1e-6));
}

void addMoves(const Mesh& patch, std::int32_t vertex, std::vector<Remedy>& remedies) {
  thread_local Star star;
  starOf(patch, vertex, star);
  if (!star.closed || patch.vertexEdge[at(vertex)] >= 0) return;
  const Point p = pointOf(patch, vertex);
  Point mean;
  double reach = 0.0;
  for (const std::int32_t rim : star.rim) {
    const Point q = pointOf(patch, startOf(patch, rim));
    mean = mean + q;
    reach += distance(p, q);
  }
  const double n = static_cast<double>(star.rim.size());
  reach /= n;
  remedies.push_back({Edit::move, vertex, (1.0 / n) * mean});
  for (const double radius : {0.06, 0.15, 0.3}) {
    for (int k = 0; k < 8; ++k) {
      const trig::SinCos turn = trig::sinCos(k * 45.0 * trig::kDegree);
      remedies.push_back({Edit::move, vertex, p + (radius * reach) * Point{turn.cos, turn.sin}});
    }
  }
}

Point centroidOf(const Mesh& mesh, std::int32_t slot) {
  const Triangle& t = triangleAt(mesh, slot);
  return (1.0 / 3.0) * (pointOf(mesh, t.v[0]) + pointOf(mesh, t.v[1]) + pointOf(mesh, t.v[2]));
}

void addInsertions(const Mesh& patch, std::int32_t slot, std::vector<Remedy>& remedies) {
  const Triangle& t = triangleAt(patch, slot);
  const Point a = pointOf(patch, t.v[0]), b = pointOf(patch, t.v[1]), c = pointOf(patch, t.v[2]);
  const Point middle = centroidOf(patch, slot);
  const Point centre = circumcentre(a, b, c);
  remedies.push_back({Edit::insert, -1, middle});
  for (const double part : {0.5, 0.75, 1.0}) remedies.push_back({Edit::insert, -1, middle + part * (centre - middle)});
  for (int i = 0; i < 3; ++i) {
    const Point m = midpoint(pointOf(patch, startOf(patch, 3 * slot + i)), pointOf(patch, endOf(patch, 3 * slot + i)));
    if (oppositeOf(patch, 3 * slot + i) >= 0) remedies.push_back({Edit::insert, -1, m});
  }
}

std::int32_t firstLive(const Mesh& mesh) {
  std::int32_t slot = 0;
  while (!mesh.alive(slot)) ++slot;
  return slot;
}

// The triangle to treat: the first that breaks a bound. In a fresh patch that is triangle 0.
std::int32_t patient(const Mesh& patch) {
  for (std::size_t slot = 0; slot < patch.triangles.size(); ++slot) {
    const auto s = static_cast<std::int32_t>(slot);
    if (patch.alive(s) && breaksBound(patch, s)) return s;
  }
  return firstLive(patch);
}

// Everything worth trying around the patch's patient.
void collectRemedies(const Mesh& patch, std::vector<Remedy>& remedies) {
  remedies.clear();
  thread_local std::vector<std::int32_t> near, slots;
  const std::int32_t centre = patient(patch);
  near.assign(triangleAt(patch, centre).v.begin(), triangleAt(patch, centre).v.end());
  slots.assign(1, centre);
  for (std::size_t k = 0; k < slots.size(); ++k) {
    for (const std::int32_t across : triangleAt(patch, slots[k]).adj) {
      if (across < 0) continue;
      if (std::find(near.begin(), near.end(), apexOf(patch, across)) == near.end())
        near.push_back(apexOf(patch, across));
      if (k == 0) slots.push_back(triangleOf(across));
    }
  }
  for (const std::int32_t vertex : near) addMoves(patch, vertex, remedies);
  for (const std::int32_t slot : slots) addInsertions(patch, slot, remedies);
  for (const std::int32_t vertex : near) {
    if (patch.vertexEdge[at(vertex)] < 0) remedies.push_back({Edit::remove, vertex, pointOf(patch, vertex)});
    for (std::int32_t e = patch.vertexEdge[at(vertex)]; e >= 0;) {
      const BoundaryEdge& edge = patch.edges[at(e)];
      remedies.push_back({Edit::split, e, midpoint(pointOf(patch, edge.v0), pointOf(patch, edge.v1))});
      e = edge.v0 == vertex ? edge.next0 : edge.next1;
    }
  }
}

// One edit, or two of which only the second shows that the first was worth it.
using Treatment = std::array<Remedy, 2>;

// Tries the remedies collected for `from` around its triangle `slot`; keeps the best treatment, and in `leads` the best
// few edits that change which vertices there are, better or not.
struct Lead {
  Badness badness;
  Remedy remedy;
};
constexpr std::size_t kLeads = 6;

void tryRemedies(const MeshState& state, const Mesh& from, double floor, const Remedy& first, Badness& best,
                 Treatment& chosen, std::vector<Lead>* leads) {
  thread_local Mesh trial;
  thread_local std::vector<Remedy> remedies;
  collectRemedies(from, remedies);
  for (const Remedy& remedy : remedies) {
    trial = from;
    if (apply(trial, state, remedy, firstLive(trial), floor).refusal != Refusal::none) continue;
    const Badness after = badnessOfAll(trial);
    if (after.shortest < floor * floor) continue;
    if (better(after, best)) {
      best = after;
      chosen = first.edit == Edit::none ? Treatment{remedy, Remedy{}} : Treatment{first, remedy};
    }
    if (leads == nullptr || remedy.edit == Edit::move) continue;
    const auto place =
        std::find_if(leads->begin(), leads->end(), [&](const Lead& l) { return better(after, l.badness); });
    leads->insert(place, {after, remedy});
    if (leads->size() > kLeads) leads->pop_back();
  }
}

// From the patch's numbering to the mesh's. What the first edit makes has the next number in both.
void translate(const MeshState& state, const Patch& patch, Remedy& remedy) {
  const auto across = [](const std::vector<std::int32_t>& map, std::size_t size, std::int32_t local) {
    const auto l = static_cast<std::size_t>(local);
    return l < map.size() ? map[l] : static_cast<std::int32_t>(size + l - map.size());
  };
  if (remedy.edit == Edit::move || remedy.edit == Edit::remove) {
    remedy.index = across(patch.vertices, state.mesh.points.size(), remedy.index);
  } else if (remedy.edit == Edit::split) {
    remedy.index = across(patch.edges, state.mesh.edges.size(), remedy.index);
  }
}

// The best treatment of the triangle, in the mesh's own numbering; none when nothing makes the patch better.
Treatment bestTreatment(const MeshState& state, std::int32_t slot, double& floor) {
  const ChangeLog::Pause onACopy;
  thread_local Patch patch;
  thread_local Mesh started;
  extractPatch(state.mesh, slot, kPatchDepth, patch);
  Badness best = badnessOfAll(patch.mesh);
  floor = floorAround(state, best);
  Treatment chosen{};
  std::vector<Lead> leads;
  tryRemedies(state, patch.mesh, floor, {}, best, chosen, &leads);
  for (std::size_t k = 0; chosen[0].edit == Edit::none && k < leads.size(); ++k) {
    started = patch.mesh;
    apply(started, state, leads[k].remedy, 0, floor);
    tryRemedies(state, started, floor, leads[k].remedy, best, chosen, nullptr);
  }
  for (Remedy& remedy : chosen) translate(state, patch, remedy);
  return chosen;
}

void record(const MeshState& state, Journal& journal, const Remedy& remedy, std::uint32_t subject, Point from,
            const Attempt& attempt) {
  if (!journal.listening()) return;
  constexpr std::array<EventKind, 5> kinds = {EventKind::vertex_refused, EventKind::vertex_moved,
                                              EventKind::vertex_inserted, EventKind::vertex_removed,
                                              EventKind::edge_split};
  Event event = eventIn(state, kinds[static_cast<std::size_t>(remedy.edit)], Rule::repair);
  event.subject = subject;
  event.at = remedy.to;
  event.from = from;
  describeAttempt(event, attempt);
  if (remedy.edit == Edit::none) event.refusal = Refusal::bound_broken;
  if (remedy.edit == Edit::move || remedy.edit == Edit::remove) event.vertex = static_cast<std::uint32_t>(remedy.index);
  if (remedy.edit == Edit::split) {
    event.subject = static_cast<std::uint32_t>(remedy.index);
    event.other = subject;
    if (attempt.vertex >= 0) event.at = pointOf(state.mesh, attempt.vertex);  // on the curve, not on the chord
  }
  if (attempt.createdCount > 0) {
    event.created = attempt.firstId;
    event.createdCount = attempt.createdCount;
  }
  journal.record(event);
}

void queueBroken(MeshState& state) {
  Mesh& mesh = state.mesh;
  std::vector<std::int32_t>& worklist = state.cursor.worklist;
  forEachUntested(mesh, kTestedRepair, [&](std::int32_t slot) {
    if (breaksBound(mesh, slot)) {
      worklist.push_back(slot);
    } else {
      mesh.tested[at(slot)] |= kTestedRepair;
    }
  });
  std::reverse(worklist.begin(), worklist.end());
}

}  // namespace

Outcome runRepair(MeshState& state, Journal& journal) {
  // phase: passes begun; index: changes made in this pass.
  Cursor& cursor = state.cursor;
  Mesh& mesh = state.mesh;
  cursor.begun = true;
  for (;;) {
    if (cursor.worklist.empty()) {
      if (cursor.phase == kPasses || (cursor.phase > 0 && cursor.index == 0)) return Outcome::done;
      ++cursor.phase;
      cursor.index = 0;
      queueBroken(state);
      if (cursor.worklist.empty()) return Outcome::done;
    }
    const std::int32_t slot = cursor.worklist.back();
    cursor.worklist.pop_back();
    if (!mesh.alive(slot) || (mesh.tested[at(slot)] & kTestedRepair) != 0 || !breaksBound(mesh, slot)) continue;
    const std::uint32_t subject = idOf(mesh, slot);
    double floor = 0.0;
    const Treatment treatment = bestTreatment(state, slot, floor);
    StageCounts& counts = state.counts[static_cast<std::size_t>(state.stage)];
    if (treatment[0].edit == Edit::none) {
      mesh.tested[at(slot)] |= kTestedRepair;
      ++counts.refused;
      record(state, journal, {Edit::none, -1, centroidOf(mesh, slot)}, subject, {}, {});
      return Outcome::decided;
    }
    ++cursor.index;
    bool inserted = false;
    thread_local std::vector<std::int32_t> gaps;
    gaps.clear();
    const std::uint32_t firstId = mesh.nextId;
    for (const Remedy& remedy : treatment) {
      if (remedy.edit == Edit::none) break;
      const Point from = remedy.edit == Edit::move ? pointOf(mesh, remedy.index) : remedy.to;
      if (remedy.edit == Edit::remove) appendStar(mesh, remedy.index, gaps);
      const std::int32_t start = mesh.alive(slot) ? slot : mesh.lastTriangle;
      const Attempt attempt = apply(mesh, state, remedy, start, floor);
      record(state, journal, remedy, subject, from, attempt);
      if (remedy.edit == Edit::move) ++counts.moved;
      if (remedy.edit == Edit::remove) ++counts.removed;
      inserted = inserted || remedy.edit == Edit::insert || remedy.edit == Edit::split;
    }
    // The steps would put back what was taken out, round after round: they pass over what fills its place.
    for (const std::int32_t gap : gaps) {
      if (mesh.alive(gap) && idOf(mesh, gap) >= firstId) mesh.tested[at(gap)] |= kTestedSteps;
    }
    if (inserted) return Outcome::inserted;
    ++cursor.changes;
    return Outcome::decided;
  }
}

}  // namespace triscope
