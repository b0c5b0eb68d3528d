// Stage "refine": step 6, the local refinements (paper, section 4, Figure 3). Passes over the mesh move points by the
// Laplacian filter, turn the sides of obtuse angles together, and move shared edges into the larger triangle; after
// each move the triangulation is made Delaunay again. Boundary vertices stay.
#include <algorithm>
#include <array>

#include "core/geometry/predicates.h"
#include "core/geometry/trig.h"
#include "core/mesh/edit.h"
#include "core/stages/refine_marks.h"
#include "core/stages/refine_trial.h"
#include "core/stages/stage_runs.h"

namespace triscope {
namespace {

enum Part : std::uint32_t { laplacian, obtuse, shared_edge, over };

constexpr double kSharedEdgeStep = 0.1;  // of the height h of the larger triangle
constexpr int kWholePasses = 6;          // the filter works everywhere in these, and near obtuse triangles in the rest
constexpr int kPatience = 3;             // passes without fewer obtuse triangles before the stage ends

bool movable(const Mesh& mesh, std::int32_t vertex) {
  return mesh.vertexEdge[at(vertex)] < 0 && mesh.vertexTriangle[at(vertex)] >= 0;
}

// Cursor::next after the last whole pass: the vertices around which a triangle is not settled.
bool marksKept(const MeshState& state) { return state.round > kWholePasses; }

// Everybody around what has changed is to be looked at again.
void markAround(Mesh& mesh, std::int32_t slot, VertexMarks& marks) {
  const Triangle& t = triangleAt(mesh, slot);
  for (const std::int32_t v : t.v) mark(marks, v);
  for (const std::int32_t across : t.adj)
    if (across >= 0) mark(marks, apexOf(mesh, across));
}

Trial tryMove(MeshState& state, const Move& move, TrialRoom& room) {
  Trial trial;
  const bool inPlace = tryInPlace(state, move, room.wheel, trial);
  if (!inPlace) trial = tryInFull(state, move, room);
  if (trial.refusal != Refusal::none || !marksKept(state)) return trial;
  if (inPlace) {
    for (const Spoke& spoke : room.wheel.spokes) markAround(state.mesh, spoke.slot, state.cursor.next);
  } else {
    for (const std::int32_t slot : room.log.slots) markAround(state.mesh, slot, state.cursor.next);
  }
  return trial;
}

// `room` holds the star of the vertex.
Outcome decideMove(MeshState& state, Journal& journal, const Move& move, std::uint32_t subject, TrialRoom& room) {
  const Point from = pointOf(state.mesh, move.vertex);
  const std::uint32_t firstId = state.mesh.nextId;
  const Trial trial = tryMove(state, move, room);
  StageCounts& counts = state.counts[static_cast<std::size_t>(state.stage)];
  const bool moved = trial.refusal == Refusal::none;
  ++(moved ? counts.moved : counts.refused);
  if (moved) ++state.cursor.changes;
  if (journal.listening()) {
    Event event = eventIn(state, moved ? EventKind::vertex_moved : EventKind::vertex_kept, move.rule);
    event.refusal = trial.refusal;
    event.subject = subject;
    event.vertex = static_cast<std::uint32_t>(move.vertex);
    event.at = move.to;
    event.from = from;
    event.measured = trial.measured;
    event.limit = trial.limit;
    if (state.mesh.nextId > firstId) {
      event.created = firstId;
      event.createdCount = state.mesh.nextId - firstId;
    }
    journal.record(event);
  }
  return Outcome::decided;
}

// Corner with an angle above 90°, or -1.
int obtuseCorner(const Mesh& mesh, std::int32_t slot) {
  const Triangle& t = triangleAt(mesh, slot);
  for (int i = 0; i < 3; ++i) {
    const Point p = pointOf(mesh, t.v[static_cast<std::size_t>(i)]);
    const Point q = pointOf(mesh, t.v[static_cast<std::size_t>(next3(i))]);
    const Point r = pointOf(mesh, t.v[static_cast<std::size_t>(prev3(i))]);
    if (dotSign(p, q, r) < 0) return i;
  }
  return -1;
}

bool obtuseSlot(const Mesh& mesh, std::int32_t slot) {
  return (mesh.tested[at(slot)] & kAcute) == 0 && obtuseCorner(mesh, slot) >= 0;
}

// True when a triangle of the star, or one beside those, is obtuse.
bool nearObtuse(const Mesh& mesh, const Wheel& wheel) {
  return std::any_of(wheel.spokes.begin(), wheel.spokes.end(), [&](const Spoke& spoke) {
    return obtuseSlot(mesh, spoke.slot) || (spoke.across >= 0 && obtuseSlot(mesh, triangleOf(spoke.across)));
  });
}

// p0 + ω (Σ (pi - p0)) / n
bool filtered(const MeshState& state, std::int32_t vertex, Wheel& wheel, Point& to) {
  const Mesh& mesh = state.mesh;
  if (!movable(mesh, vertex) || !gather(mesh, vertex, wheel)) return false;
  const auto isSettled = [&](const Spoke& spoke) { return settled(mesh, spoke.slot); };
  if (std::all_of(wheel.spokes.begin(), wheel.spokes.end(), isSettled)) return false;
  if (state.round > kWholePasses && !nearObtuse(mesh, wheel)) return false;
  const Point p = pointOf(mesh, vertex);
  Point sum;
  for (const Spoke& spoke : wheel.spokes) sum = sum + (spoke.at - p);
  to = p + (state.settings.omega / static_cast<double>(wheel.spokes.size())) * sum;
  return true;
}

Point turned(Point p, Point about, trig::SinCos by) {
  const Point d = p - about;
  return about + Point{d.x * by.cos - d.y * by.sin, d.x * by.sin + d.y * by.cos};
}

// Edge of the triangle over which its neighbour is larger by the given factor, or -1.
int largeNeighbour(const Mesh& mesh, std::int32_t slot) {
  const double own = twiceArea(mesh, slot);
  for (int i = 0; i < 3; ++i) {
    const std::int32_t across = oppositeOf(mesh, 3 * slot + i);
    if (across >= 0 && twiceArea(mesh, triangleOf(across)) > kLargeAreaRatio * own) return i;
  }
  return -1;
}

// Where the corner p2 of an obtuse angle must go, straight away from the far side p1p3, for the angle to shrink by 2θ
// at most: the way out when p1 and p3 may not move, or not far enough.
Point apexRaised(Point p1, Point p2, Point p3, double theta) {
  const Point side = p3 - p1;
  const Point away = (1.0 / length(side)) * perpendicular(p1 - p3);
  const double height = dot(p2 - p1, away);
  const double target = 0.5 * length(side) / std::sqrt(3.0);
  return p2 + std::min(theta * length(side), std::max(0.0, target - height)) * away;
}

// Turns to try in units of θ: the full one first, then half and twice, each for p1, p3 and p2. The first that is
// accepted ends the obtuse angle or makes it smaller, and the triangle is looked at again in the next pass.
constexpr std::array<double, 3> kTurns = {1.0, 0.5, 2.0};
constexpr std::uint64_t kTries = 3 * kTurns.size();

// index = 9·slot + try.
Outcome runObtuse(MeshState& state, Journal& journal, TrialRoom& room) {
  Cursor& cursor = state.cursor;
  Mesh& mesh = state.mesh;
  for (; cursor.index < kTries * mesh.triangles.size(); ++cursor.index) {
    const std::size_t open = nextOpen(mesh, cursor.index / kTries, kAcute);
    if (open != cursor.index / kTries) cursor.index = kTries * open;
    if (open == mesh.triangles.size()) break;
    const auto slot = static_cast<std::int32_t>(open);
    const int corner = obtuseCorner(mesh, slot);
    if (corner < 0) {
      mesh.tested[open] |= kAcute;
      cursor.index += kTries - 1 - cursor.index % kTries;  // on to the next triangle
      continue;
    }
    const Triangle& t = triangleAt(mesh, slot);
    const std::int32_t p2 = t.v[static_cast<std::size_t>(corner)];
    const std::int32_t p1 = t.v[static_cast<std::size_t>(next3(corner))];
    const std::int32_t p3 = t.v[static_cast<std::size_t>(prev3(corner))];
    const std::uint64_t which = cursor.index % 3;
    const double theta = kTurns[cursor.index % kTries / 3] * state.settings.theta * trig::kDegree;
    const std::int32_t moved = which == 0 ? p1 : which == 1 ? p3 : p2;
    if (!movable(mesh, moved) || !gather(mesh, moved, room.wheel)) continue;
    const Point about = pointOf(mesh, p2);
    const Point to = which == 2 ? apexRaised(pointOf(mesh, p1), about, pointOf(mesh, p3), theta)
                                : turned(pointOf(mesh, moved), about, trig::sinCos(which == 0 ? theta : -theta));
    ++cursor.index;
    return decideMove(state, journal, {Rule::reduce_obtuse, moved, to}, idOf(mesh, slot), room);
  }
  return Outcome::done;
}

// index = 2·slot + end of the edge.
Outcome runSharedEdge(MeshState& state, Journal& journal, TrialRoom& room) {
  Cursor& cursor = state.cursor;
  Mesh& mesh = state.mesh;
  for (; cursor.index < 2 * mesh.triangles.size(); ++cursor.index) {
    const std::size_t open = nextOpen(mesh, cursor.index / 2, kEven);
    if (open != cursor.index / 2) cursor.index = 2 * open;
    if (open == mesh.triangles.size()) break;
    const auto slot = static_cast<std::int32_t>(open);
    const int edge = largeNeighbour(mesh, slot);
    if (edge < 0) {
      mesh.tested[open] |= kEven;
      continue;
    }
    const std::int32_t half = 3 * slot + edge;
    const std::int32_t moved = cursor.index % 2 == 1 ? endOf(mesh, half) : startOf(mesh, half);
    if (!movable(mesh, moved) || !gather(mesh, moved, room.wheel)) continue;
    const Point along = pointOf(mesh, endOf(mesh, half)) - pointOf(mesh, startOf(mesh, half));
    const double height = twiceArea(mesh, triangleOf(oppositeOf(mesh, half))) / length(along);
    const Point into = (-kSharedEdgeStep * height / length(along)) * perpendicular(along);
    ++cursor.index;
    const Move move{Rule::shared_edge, moved, pointOf(mesh, moved) + into};
    return decideMove(state, journal, move, idOf(mesh, slot), room);
  }
  return Outcome::done;
}

Outcome runLaplacian(MeshState& state, Journal& journal, TrialRoom& room) {
  Cursor& cursor = state.cursor;
  for (;;) {
    if (marksKept(state)) cursor.index = nextMarked(cursor.next, cursor.index);
    if (cursor.index >= state.mesh.points.size()) return Outcome::done;
    const auto vertex = static_cast<std::int32_t>(cursor.index++);
    Point to;
    if (!filtered(state, vertex, room.wheel, to)) continue;
    return decideMove(state, journal, {Rule::laplacian, vertex, to}, kNoId, room);
  }
}

// Between passes: what the pass left unchanged is settled. Returns the number of obtuse triangles.
std::int32_t settle(MeshState& state) {
  Mesh& mesh = state.mesh;
  VertexMarks& marks = state.cursor.next;
  const bool last = state.round >= kWholePasses;  // of the whole passes, or none
  if (last) marks.assign((mesh.points.size() + 31) / 32, 0);
  std::int32_t count = 0;
  for (std::size_t slot = 0; slot < mesh.triangles.size(); ++slot) {
    std::uint8_t& tested = mesh.tested[slot];
    if ((mesh.flags[slot] & kDead) != 0) continue;
    if ((tested & kUnchanged) != 0) tested |= kSettled;
    tested |= kUnchanged;
    if ((tested & kAcute) == 0) {
      const bool isObtuse = obtuseCorner(mesh, static_cast<std::int32_t>(slot)) >= 0;
      if (isObtuse) ++count;
      if (!isObtuse) tested |= kAcute;
    }
    if (!last || (tested & kSettled) != 0) continue;
    for (const std::int32_t v : mesh.triangles[slot].v) mark(marks, v);
  }
  return count;
}

// What the rules before this step remember of triangles says nothing about its own.
void forgetTests(Mesh& mesh) {
  for (std::size_t slot = 0; slot < mesh.tested.size(); ++slot)
    if ((mesh.flags[slot] & kDead) == 0) mesh.tested[slot] = 0;
}

}  // namespace

Outcome runRefine(MeshState& state, Journal& journal) {
  // round: the pass, from 1; phase: part of the pass; worklist: fewest obtuse so far, passes since; next: marks.
  thread_local TrialRoom room;
  Cursor& cursor = state.cursor;
  const Settings& settings = state.settings;
  if (!cursor.begun) {
    cursor.begun = true;
    state.round = 1;
    forgetTests(state.mesh);
    cursor.worklist = {settle(state), 0};
  }
  for (;;) {
    Outcome outcome = Outcome::done;
    if (cursor.phase == laplacian && settings.laplacian) outcome = runLaplacian(state, journal, room);
    if (cursor.phase == obtuse && settings.reduceObtuse) outcome = runObtuse(state, journal, room);
    if (cursor.phase == shared_edge && settings.sharedEdge) outcome = runSharedEdge(state, journal, room);
    if (cursor.phase == over) return Outcome::done;
    if (outcome != Outcome::done) return outcome;
    cursor.index = 0;
    if (++cursor.phase != over) continue;
    const std::int32_t left = settle(state);
    cursor.worklist[1] = left < cursor.worklist[0] ? 0 : cursor.worklist[1] + 1;
    cursor.worklist[0] = std::min(left, cursor.worklist[0]);
    if (left == 0 || cursor.worklist[1] >= kPatience || state.round >= settings.refinePasses) return Outcome::done;
    ++state.round;
    cursor.phase = laplacian;
  }
}

}  // namespace triscope
