// Stage "refine": step 6, the local refinements (paper, section 4, Figure 3). Passes over the mesh turn the sides of
// obtuse angles together, move shared edges into the larger triangle, and move points by the Laplacian filter; passes
// after them look only at what is poor, and polish it. After each move the triangulation is made Delaunay again.
// Boundary vertices stay. The number of passes does not grow with the mesh.
#include <algorithm>
#include <array>

#include "core/geometry/predicates.h"
#include "core/geometry/trig.h"
#include "core/mesh/edit.h"
#include "core/method/stages/refine_marks.h"
#include "core/method/stages/refine_polish.h"
#include "core/method/stages/refine_trial.h"
#include "core/method/stages/stage_runs.h"

namespace triscope {
namespace {

enum RefinePart : std::uint32_t { obtuse, shared_edge, laplacian, polish, pass_over };

constexpr double kSharedEdgeStep = 0.1;  // of the height h of the larger triangle
constexpr int kWholePasses = 1;          // over the whole mesh; those after them only near what is poor
constexpr int kPoorPasses = 7;

// Corner with an angle above 90°, or -1.
int obtuseCorner(const Mesh& mesh, Slot slot) {
  const Triangle& t = triangleAt(mesh, slot);
  for (int i = 0; i < 3; ++i) {
    const Point p = pointOf(mesh, t.v[i]);
    const Point q = pointOf(mesh, t.v[next3(i)]);
    const Point r = pointOf(mesh, t.v[prev3(i)]);
    if (dotSign(p, q, r) < 0) return i;
  }
  return -1;
}

// One pass goes as far as 24 by ω would, with the neighbours at rest: 1 - (1 - ω)^24 of the way.
double filterPart(double omega) {
  double left = 1.0 - omega;
  left = left * left * left;
  for (int k = 0; k < 3; ++k) left = left * left;
  return 1.0 - left;
}

// p0 + part · (Σ (pi - p0)) / n
bool filtered(const MeshState& state, Vertex vertex, Wheel& wheel, Point& to) {
  const Mesh& mesh = state.mesh;
  if (!movable(mesh, vertex) || !gather(mesh, vertex, wheel)) return false;
  const auto isSettled = [&](const Spoke& spoke) { return settled(mesh, spoke.slot); };
  if (std::all_of(wheel.spokes.begin(), wheel.spokes.end(), isSettled)) return false;
  const Point p = pointOf(mesh, vertex);
  Point sum;
  for (const Spoke& spoke : wheel.spokes) sum = sum + (spoke.at - p);
  to = p + (filterPart(state.settings.omega) / static_cast<double>(wheel.spokes.size())) * sum;
  return true;
}

Point turned(Point p, Point about, trig::SinCos by) {
  const Point d = p - about;
  return about + Point{d.x * by.cos - d.y * by.sin, d.x * by.sin + d.y * by.cos};
}

// Edge of the triangle over which its neighbour is larger by the given factor, or -1.
int largeNeighbour(const Mesh& mesh, Slot slot) {
  const double own = twiceArea(mesh, slot);
  for (int i = 0; i < 3; ++i) {
    const Half across = oppositeOf(mesh, halfOf(slot, i));
    if (across.exists() && twiceArea(mesh, triangleOf(across)) > kLargeAreaRatio * own) return i;
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
// accepted ends the obtuse angle or makes it smaller, and the triangle is looked at again in the next pass. The whole
// pass has only the first two, the paper's own: the filter that follows ends most of the others at once.
constexpr std::array<double, 3> kTurns = {1.0, 0.5, 2.0};
constexpr std::uint64_t kTries = 3 * kTurns.size();
constexpr std::uint64_t kTriesOfWholePass = 2;

// index = 9·slot + try.
Outcome runObtuse(MeshState& state, Journal& journal, TrialRoom& room) {
  Cursor& cursor = state.cursor;
  Mesh& mesh = state.mesh;
  for (; cursor.index < kTries * mesh.triangles.size(); ++cursor.index) {
    const std::size_t open = nextOpen(mesh, cursor.index / kTries, kAcute);
    if (open != cursor.index / kTries) cursor.index = kTries * open;
    if (open == mesh.triangles.size()) break;
    const Slot slot(open);
    const bool tried = state.round <= kWholePasses && cursor.index % kTries >= kTriesOfWholePass;
    const int corner = tried ? -1 : obtuseCorner(mesh, slot);
    if (corner < 0) {
      if (!tried) mesh.tested[slot] |= kAcute;
      cursor.index += kTries - 1 - cursor.index % kTries;  // on to the next triangle
      continue;
    }
    const Triangle& t = triangleAt(mesh, slot);
    const Vertex p2 = t.v[corner];
    const Vertex p1 = t.v[next3(corner)];
    const Vertex p3 = t.v[prev3(corner)];
    const std::uint64_t which = cursor.index % 3;
    const double theta = kTurns[cursor.index % kTries / 3] * state.settings.theta * trig::kDegree;
    const Vertex moved = which == 0 ? p1 : which == 1 ? p3 : p2;
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
    const Slot slot(open);
    const int edge = largeNeighbour(mesh, slot);
    if (edge < 0) {
      mesh.tested[slot] |= kEven;
      continue;
    }
    const Half half = halfOf(slot, edge);
    const Vertex moved = cursor.index % 2 == 1 ? endOf(mesh, half) : startOf(mesh, half);
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
  while (cursor.index < state.mesh.points.size()) {
    const Vertex vertex(cursor.index++);
    Point to;
    if (!filtered(state, vertex, room.wheel, to)) continue;
    return decideMove(state, journal, {Rule::laplacian, vertex, to}, {}, room);
  }
  return Outcome::done;
}

// The next decision of the part of the pass that is at hand.
Outcome runPart(MeshState& state, Journal& journal, TrialRoom& room) {
  const Settings& settings = state.settings;
  const bool whole = state.round <= kWholePasses;
  switch (static_cast<RefinePart>(state.cursor.phase)) {
    case obtuse:
      return settings.reduceObtuse ? runObtuse(state, journal, room) : Outcome::done;
    case shared_edge:
      return settings.sharedEdge ? runSharedEdge(state, journal, room) : Outcome::done;
    case laplacian:
      return settings.laplacian && whole ? runLaplacian(state, journal, room) : Outcome::done;
    case polish:
      return settings.polish && !whole ? runPolish(state, journal, room) : Outcome::done;
    case pass_over:
      break;
  }
  return Outcome::done;
}

// Between passes: what the pass left unchanged is settled. False when that is all.
bool settle(MeshState& state) {
  Mesh& mesh = state.mesh;
  bool changed = false;
  for (std::uint8_t& tested : mesh.tested) {
    if ((tested & kSettled) != 0) continue;
    if ((tested & kUnchanged) != 0) {
      tested |= kSettled;
    } else {
      tested |= kUnchanged;
      changed = true;
    }
  }
  return changed;
}

// What the rules before this step remember of triangles says nothing about its own.
void forgetTests(Mesh& mesh) {
  for (const Slot slot : mesh.tested.keys())
    if (mesh.alive(slot)) mesh.tested[slot] = kUnchanged;
}

}  // namespace

Outcome runRefine(MeshState& state, Journal& journal) {
  // round: the pass, from 1; phase: part of the pass; the rest is its own business.
  TrialRoom& room = state.room.moves;
  Cursor& cursor = state.cursor;
  if (!cursor.begun) {
    cursor.begun = true;
    state.round = 1;
    forgetTests(state.mesh);
  }
  while (cursor.phase != pass_over) {
    const Outcome outcome = runPart(state, journal, room);
    if (outcome != Outcome::done) return outcome;
    cursor.index = 0;
    if (++cursor.phase != pass_over) continue;
    const bool changed = settle(state);
    if (state.round == kWholePasses) beginPolish(state);
    const bool last = state.round >= std::min(state.settings.refinePasses, kWholePasses + kPoorPasses);
    if (last || (!changed && state.round > kWholePasses)) break;
    ++state.round;
    cursor.phase = obtuse;
  }
  return Outcome::done;
}

}  // namespace triscope
