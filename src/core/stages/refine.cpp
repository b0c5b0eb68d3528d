// Stage "refine": step 6, the local refinements (paper, section 4, Figure 3). Passes over the mesh move points by the
// Laplacian filter, turn the sides of obtuse angles together, and move shared edges into the larger triangle; after
// each move the triangulation is made Delaunay again. Boundary vertices stay.
#include <algorithm>
#include <array>

#include "core/geometry/predicates.h"
#include "core/geometry/trig.h"
#include "core/mesh/badness.h"
#include "core/mesh/edit.h"
#include "core/mesh/move.h"
#include "core/stages/stage_runs.h"

namespace triscope {
namespace {

enum Part : std::uint32_t { laplacian, obtuse, shared_edge, over };

constexpr double kLargeAreaRatio = 2.0;    // pairs beyond it get their shared edge moved
constexpr double kLargeAspect = 3.0;       // a shared edge may be moved as long as no aspect ratio grows beyond it
constexpr double kLargeEdgeRatio = 1.935;  // the paper ends at 1.94: no move goes beyond, or beyond what was
constexpr double kSharedEdgeStep = 0.1;    // of the height h of the larger triangle
// Bits of Mesh::tested, cleared whenever a triangle or a neighbour changes.
constexpr std::uint8_t kSettled = 64;     // unchanged through a whole pass: the next would refuse the same again
constexpr std::uint8_t kUnchanged = 128;  // since this pass began
constexpr int kWholePasses = 6;           // the filter works everywhere in these, and near obtuse triangles in the rest
constexpr int kPatience = 3;              // passes without fewer obtuse triangles before the stage ends

thread_local MoveLog moveLog;
thread_local Star star;
thread_local std::vector<std::int32_t> before;

bool movable(const Mesh& mesh, std::int32_t vertex) {
  return mesh.vertexEdge[at(vertex)] < 0 && mesh.vertexTriangle[at(vertex)] >= 0;
}

// Why the region after a move is worse than before; none when it is not. Each part of the step answers for the measure
// it is there to improve, and may not spoil the others beyond what is large.
Refusal judge(Rule rule, const Badness& was, const Badness& is, double minEdge) {
  if (is.broken > was.broken || is.excess > was.excess) return Refusal::bound_broken;
  if (is.shortest < minEdge * minEdge && is.shortest < was.shortest) return Refusal::edge_below_minimum;
  if (is.obtuse > was.obtuse) return Refusal::star_worse;
  if (is.areaRatio > std::max(was.areaRatio, kLargeAreaRatio)) return Refusal::star_worse;
  if (is.edgeRatio > std::max(was.edgeRatio, kLargeEdgeRatio * kLargeEdgeRatio)) return Refusal::star_worse;
  if (is.obtuse < was.obtuse) return Refusal::none;
  const bool worse = rule == Rule::shared_edge
                         ? is.areaRatio >= was.areaRatio || is.worst > std::max(was.worst, kLargeAspect)
                         : is.worst > was.worst;
  return worse ? Refusal::star_worse : Refusal::none;
}

struct Trial {
  Refusal refusal = Refusal::none;
  double measured = 0.0;  // worst aspect ratio after, and before
  double limit = 0.0;
};

// Moves the vertex when the region it changes is no worse for it.
Trial tryMove(MeshState& state, Rule rule, std::int32_t vertex, Point to) {
  Mesh& mesh = state.mesh;
  starOf(mesh, vertex, star);
  before.clear();
  std::uint8_t finestRank = mesh.density[at(vertex)];
  for (const std::int32_t rim : star.rim) {
    before.push_back(triangleOf(rim));
    finestRank = std::min(finestRank, mesh.density[at(startOf(mesh, rim))]);
  }
  Badness was = badnessOf(mesh, before);
  if (!moveVertex(mesh, vertex, to, moveLog)) return {Refusal::inverts_triangle, 0.0, 0.0};
  const Badness is = badnessOf(mesh, moveLog.slots);
  const bool flipped = moveLog.flips > 0;
  if (flipped) {  // the region has grown by the triangles flipped: look at all of it as it was
    undoMove(mesh, moveLog);
    was = badnessOf(mesh, moveLog.slots);
  }
  // Δx, or less where kept input edges made the density finer than that.
  const double finest = std::min(state.minEdge, state.tree.minEdge * rankLength(finestRank));
  const Refusal refusal = judge(rule, was, is, finest);
  if (refusal == Refusal::none && flipped) moveVertex(mesh, vertex, to, moveLog);
  if (refusal != Refusal::none && !flipped) undoMove(mesh, moveLog);
  const bool byEdge = refusal == Refusal::edge_below_minimum;
  return {refusal, byEdge ? std::sqrt(is.shortest) : is.worst, byEdge ? finest : was.worst};
}

Outcome decideMove(MeshState& state, Journal& journal, Rule rule, std::uint32_t subject, std::int32_t vertex,
                   Point to) {
  const Point from = pointOf(state.mesh, vertex);
  const std::uint32_t firstId = state.mesh.nextId;
  const Trial trial = tryMove(state, rule, vertex, to);
  StageCounts& counts = state.counts[static_cast<std::size_t>(state.stage)];
  const bool moved = trial.refusal == Refusal::none;
  ++(moved ? counts.moved : counts.refused);
  if (moved) ++state.cursor.changes;
  if (journal.listening()) {
    Event event = eventIn(state, moved ? EventKind::vertex_moved : EventKind::vertex_kept, rule);
    event.refusal = trial.refusal;
    event.subject = subject;
    event.vertex = static_cast<std::uint32_t>(vertex);
    event.at = to;
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

bool settled(const Mesh& mesh) {
  return std::all_of(star.rim.begin(), star.rim.end(),
                     [&](std::int32_t rim) { return (mesh.tested[at(triangleOf(rim))] & kSettled) != 0; });
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

// True when a triangle around the vertex of `star`, or one beside those, is obtuse.
bool nearObtuse(const Mesh& mesh) {
  for (const std::int32_t rim : star.rim) {
    if (obtuseCorner(mesh, triangleOf(rim)) >= 0) return true;
    const std::int32_t across = oppositeOf(mesh, rim);
    if (across >= 0 && obtuseCorner(mesh, triangleOf(across)) >= 0) return true;
  }
  return false;
}

// p0 + ω (Σ (pi - p0)) / n
bool filtered(const Mesh& mesh, std::int32_t vertex, double omega, int pass, Point& to) {
  if (!movable(mesh, vertex)) return false;
  starOf(mesh, vertex, star);
  if (!star.closed || settled(mesh)) return false;
  if (pass > kWholePasses && !nearObtuse(mesh)) return false;
  const Point p = pointOf(mesh, vertex);
  Point sum;
  for (const std::int32_t rim : star.rim) sum = sum + (pointOf(mesh, startOf(mesh, rim)) - p);
  to = p + (omega / static_cast<double>(star.rim.size())) * sum;
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
Outcome runObtuse(MeshState& state, Journal& journal) {
  Cursor& cursor = state.cursor;
  Mesh& mesh = state.mesh;
  for (; cursor.index < kTries * mesh.triangles.size(); ++cursor.index) {
    const auto slot = static_cast<std::int32_t>(cursor.index / kTries);
    const int corner = !mesh.alive(slot) || (mesh.tested[at(slot)] & kSettled) != 0 ? -1 : obtuseCorner(mesh, slot);
    if (corner < 0) {
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
    if (!movable(mesh, moved)) continue;
    const Point about = pointOf(mesh, p2);
    const Point to = which == 2 ? apexRaised(pointOf(mesh, p1), about, pointOf(mesh, p3), theta)
                                : turned(pointOf(mesh, moved), about, trig::sinCos(which == 0 ? theta : -theta));
    ++cursor.index;
    return decideMove(state, journal, Rule::reduce_obtuse, idOf(mesh, slot), moved, to);
  }
  return Outcome::done;
}

Outcome runSharedEdge(MeshState& state, Journal& journal) {
  Cursor& cursor = state.cursor;
  Mesh& mesh = state.mesh;
  for (; cursor.index < 2 * mesh.triangles.size(); ++cursor.index) {
    const auto slot = static_cast<std::int32_t>(cursor.index / 2);
    if (!mesh.alive(slot) || (mesh.tested[at(slot)] & kSettled) != 0) continue;
    const int edge = largeNeighbour(mesh, slot);
    if (edge < 0) continue;
    const std::int32_t half = 3 * slot + edge;
    const std::int32_t moved = cursor.index % 2 == 1 ? endOf(mesh, half) : startOf(mesh, half);
    if (!movable(mesh, moved)) continue;
    const Point along = pointOf(mesh, endOf(mesh, half)) - pointOf(mesh, startOf(mesh, half));
    const double height = twiceArea(mesh, triangleOf(oppositeOf(mesh, half))) / length(along);
    const Point into = (-kSharedEdgeStep * height / length(along)) * perpendicular(along);
    ++cursor.index;
    return decideMove(state, journal, Rule::shared_edge, idOf(mesh, slot), moved, pointOf(mesh, moved) + into);
  }
  return Outcome::done;
}

Outcome runLaplacian(MeshState& state, Journal& journal) {
  Cursor& cursor = state.cursor;
  while (cursor.index < state.mesh.points.size()) {
    const auto vertex = static_cast<std::int32_t>(cursor.index++);
    Point to;
    if (!filtered(state.mesh, vertex, state.settings.omega, state.round, to)) continue;
    return decideMove(state, journal, Rule::laplacian, kNoId, vertex, to);
  }
  return Outcome::done;
}

// Between passes: what the pass left unchanged is settled. Returns the number of obtuse triangles.
std::int32_t settle(Mesh& mesh) {
  std::int32_t count = 0;
  for (std::size_t slot = 0; slot < mesh.triangles.size(); ++slot) {
    if ((mesh.flags[slot] & kDead) != 0) continue;
    std::uint8_t& tested = mesh.tested[slot];
    if ((tested & kUnchanged) != 0) tested |= kSettled;
    tested |= kUnchanged;
    if (obtuseCorner(mesh, static_cast<std::int32_t>(slot)) >= 0) ++count;
  }
  return count;
}

}  // namespace

Outcome runRefine(MeshState& state, Journal& journal) {
  // round: the pass, from 1; phase: part of the pass; worklist: fewest obtuse so far, passes since.
  Cursor& cursor = state.cursor;
  const Settings& settings = state.settings;
  if (!cursor.begun) {
    cursor.begun = true;
    state.round = 1;
    cursor.worklist = {settle(state.mesh), 0};
  }
  for (;;) {
    Outcome outcome = Outcome::done;
    if (cursor.phase == laplacian && settings.laplacian) outcome = runLaplacian(state, journal);
    if (cursor.phase == obtuse && settings.reduceObtuse) outcome = runObtuse(state, journal);
    if (cursor.phase == shared_edge && settings.sharedEdge) outcome = runSharedEdge(state, journal);
    if (cursor.phase == over) return Outcome::done;
    if (outcome != Outcome::done) return outcome;
    cursor.index = 0;
    if (++cursor.phase != over) continue;
    const std::int32_t left = settle(state.mesh);
    cursor.worklist[1] = left < cursor.worklist[0] ? 0 : cursor.worklist[1] + 1;
    cursor.worklist[0] = std::min(left, cursor.worklist[0]);
    if (left == 0 || cursor.worklist[1] >= kPatience || state.round >= settings.refinePasses) return Outcome::done;
    ++state.round;
    cursor.phase = laplacian;
  }
}

}  // namespace triscope
