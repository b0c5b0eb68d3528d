#include "core/method/stages/optimise_parts.h"

#include <algorithm>

#include "core/mesh/centroid.h"
#include "core/optimise/cure.h"
#include "core/optimise/relax.h"
#include "core/optimise/smooth.h"

namespace triscope {
namespace {

constexpr std::uint8_t kAsleep = 2;  // passes in a row that a vertex has hardly moved in

using SmoothRule = SmoothStep (*)(const Ring&, Point, double);

struct Moved {
  Rule rule;
  Vertex vertex;
  Point from;
  Point to;
  Refusal refusal = Refusal::none;
  double measured = 0.0;
  double limit = 0.0;
  TriangleId firstId;  // before any flips that the move called for
};

Outcome decideMoved(Optimiser& o, const Moved& move) {
  MeshState& state = o.state;
  const bool moved = move.refusal == Refusal::none;
  ++(moved ? state.counts[state.stage].moved : state.counts[state.stage].refused);
  if (moved) ++state.cursor.changes;
  if (o.journal.listening()) {
    Event event = eventIn(state, moved ? EventKind::vertex_moved : EventKind::vertex_kept, move.rule);
    event.refusal = move.refusal;
    event.vertex = move.vertex.word();
    event.at = move.to;
    event.from = move.from;
    event.measured = move.measured;
    event.limit = move.limit;
    if (state.mesh.nextId > move.firstId) {
      event.created = move.firstId.n;
      event.createdCount = state.mesh.nextId.n - move.firstId.n;
    }
    o.journal.record(event);
  }
  return Outcome::decided;
}

void wakeAround(Optimiser& o, const Ring& ring) {
  for (const Vertex v : ring.neighbours()) o.ahead.still[v] = 0;
}

Outcome runSmoothing(Optimiser& o, Rule rule, SmoothRule stepOf) {
  MeshState& state = o.state;
  Mesh& mesh = state.mesh;
  std::uint64_t& index = state.cursor.index;
  Ring& ring = o.work.room.ring;
  for (int looked = 0; index < mesh.points.size(); ++looked) {
    if (looked == kPiece) return Outcome::worked;
    const Vertex vertex(index++);
    std::uint8_t& still = o.ahead.still[vertex];
    if (still >= kAsleep || mesh.vertexEdge[vertex].exists()) continue;
    if (!gatherRing(mesh, state.sizes, vertex, ring) || !ring.closed) continue;
    const Point from = pointOf(mesh, vertex);
    const SmoothStep step = stepOf(ring, from, state.sizes[vertex]);
    if (step.kind == StepKind::still) {
      ++still;
      continue;
    }
    const bool moves = step.kind == StepKind::moves;
    if (moves) {
      mesh.points[vertex] = step.to;
      noteRing(mesh, ring);
      if (step.wakes) {
        still = 0;
        wakeAround(o, ring);
      }
    }
    return decideMoved(o, {.rule = rule,
                           .vertex = vertex,
                           .from = from,
                           .to = step.to,
                           .refusal = moves ? Refusal::none : Refusal::too_thin,
                           .firstId = mesh.nextId});
  }
  return Outcome::done;
}

// The edge opposite an obtuse angle, none where there is none, up to rounding. An edge that is not Delaunay lies
// opposite two angles of more than 180° together: one of them is obtuse.
Half oppositeObtuse(const Mesh& mesh, Slot slot) {
  constexpr double kHalf = 0.4999999;
  const Triangle& t = triangleAt(mesh, slot);
  const Point a = pointOf(mesh, t.v[0]), b = pointOf(mesh, t.v[1]), c = pointOf(mesh, t.v[2]);
  const Corners<double> edges{squaredDistance(b, c), squaredDistance(c, a), squaredDistance(a, b)};
  const double limit = kHalf * (edges[0] + edges[1] + edges[2]);
  for (int i = 0; i < 3; ++i)
    if (edges[i] > limit) return halfOf(slot, i);
  return {};
}

void queueNext(Optimiser& o, Vertex vertex) {
  if (o.ahead.waits[vertex] != 0) return;
  o.ahead.waits[vertex] = 1;
  o.ahead.next.push_back(vertex);
}

/// Calls visit(saved) for each vertex that the log has of the mesh before, as it was then.
template <class Visit>
void forEachSaved(Optimiser& o, const EditMark& before, const Visit& visit) {
  Marks<Vertex>& seen = o.work.room.seen;
  seen.begin(o.state.mesh.points.size());
  for (const EditLog::SavedVertex& saved : o.work.room.log.vertices)
    if (saved.vertex < Vertex(before.allVertices) && seen.take(saved.vertex)) visit(saved);
}

bool isGone(const Mesh& mesh, Vertex vertex) { return mesh.kinds[vertex] == VertexKind::removed; }

void recordTouched(Optimiser& o, const EditReport& report, const EditMark& before) {
  const Mesh& mesh = o.state.mesh;
  const auto about = [&](EventKind kind, Vertex vertex) {
    Event event = eventIn(o.state, kind, report.rule);
    event.subject = report.subject.n;
    event.vertex = vertex.word();
    event.at = pointOf(mesh, vertex);
    return event;
  };
  for (Vertex v(before.allVertices); mesh.points.has(v); ++v) {
    const bool border = mesh.vertexEdge[v].exists();
    Event event = about(border ? EventKind::edge_split : EventKind::vertex_inserted, v);
    if (border) {
      event.other = report.subject.n;
      event.subject = mesh.vertexEdge[v].word();
    }
    o.journal.record(event);
  }
  forEachSaved(o, before, [&](const EditLog::SavedVertex& saved) {
    const bool gone = isGone(mesh, saved.vertex);
    if (!gone && pointOf(mesh, saved.vertex) == saved.at) return;
    Event event = about(gone ? EventKind::vertex_removed : EventKind::vertex_moved, saved.vertex);
    event.from = saved.at;
    o.journal.record(event);
  });
}

Event eventOf(const Optimiser& o, EventKind kind, const EditReport& report) {
  Event event = eventIn(o.state, kind, report.rule);
  event.refusal = report.refusal;
  event.subject = report.subject.n;
  event.vertex = report.vertex.word();
  event.at = report.at;
  event.measured = report.measured;
  event.limit = report.limit;
  return event;
}

}  // namespace

Outcome runSmooth(Optimiser& o) { return runSmoothing(o, Rule::smooth, meanOfCircumcentres); }
Outcome runShape(Optimiser& o) { return runSmoothing(o, Rule::best_shape, towardBestShape); }

Outcome runFlips(Optimiser& o) {
  Mesh& mesh = o.state.mesh;
  std::uint64_t& index = o.state.cursor.index;
  for (int looked = 0; index < mesh.triangles.size(); ++looked) {
    if (looked == kPiece) return Outcome::worked;
    const Slot slot(index++);
    if (!mesh.alive(slot)) continue;
    const Half half = oppositeObtuse(mesh, slot);
    if (!half.exists() || !flipWanted(mesh, half)) continue;
    OptimiserRoom& room = o.work.room;
    beginEdits(room.log);
    const EditMark before = markOf(mesh, room.log);
    const EditReport report{.rule = Rule::delaunay_flip, .subject = idOf(mesh, slot), .at = centroidOf(mesh, slot)};
    room.suspects.assign(1, half);
    flipSuspects(o.work);
    return decideKept(o, report, before);
  }
  return Outcome::done;
}

Outcome runAnneal(Optimiser& o) {
  const Mesh& mesh = o.state.mesh;
  std::uint64_t& index = o.state.cursor.index;
  int looked = 0;
  for (int tried = 0; index < mesh.points.size(); ++looked) {
    if (looked == kPiece || tried == kPiece) return Outcome::worked;
    const Vertex vertex(index++);
    if (o.ahead.excess[vertex] == 0 || mesh.vertexEdge[vertex].exists()) continue;
    EditReport report{.rule = Rule::anneal, .vertex = vertex, .at = pointOf(mesh, vertex)};
    const EditMark before = markOf(mesh, {});
    const Glide glide = glideFrom(o.work, o.ahead.excess, vertex);
    tried += glide.searched;
    if (glide.outcome == GlideOutcome::none) continue;
    report.measured = glide.sumAfter;
    report.limit = glide.sumBefore;
    if (glide.outcome == GlideOutcome::undone) {
      report.refusal = Refusal::patch_worse;
      return decideUndone(o, report);
    }
    for (const Vertex v : o.work.room.patch) o.ahead.still[v] = 0;
    return decideKept(o, report, before);
  }
  return Outcome::done;
}

void beginRelax(Optimiser& o) {
  const Mesh& mesh = o.state.mesh;
  const PenaltyLimits limits = limitsFor(aimsOf(o.state.settings));
  Optimising& ahead = o.ahead;
  ahead.excess = {};
  ahead.still = {};
  ahead.waits.assign(mesh.points.size(), 0);
  ahead.visits.assign(mesh.points.size(), 0);
  for (const Slot slot : mesh.triangles.keys()) {
    if (!mesh.alive(slot) || penaltyOf(mesh, o.state.sizes, slot, limits) < kRelaxed) continue;
    for (const Vertex v : triangleAt(mesh, slot).v) queueNext(o, v);
  }
}

Outcome runRelax(Optimiser& o) {
  constexpr std::uint8_t kVisits = 20;  // of a vertex
  MeshState& state = o.state;
  Optimising& ahead = o.ahead;
  std::uint64_t& index = state.cursor.index;
  const PenaltyLimits limits = limitsFor(aimsOf(state.settings));
  Ring& ring = o.work.room.ring;
  for (int looked = 0;; ++looked) {
    if (looked == kPiece) return Outcome::worked;
    if (index == ahead.ahead.size()) {
      index = 0;
      ahead.ahead.swap(ahead.next);
      ahead.next.clear();
      if (ahead.ahead.empty()) return Outcome::done;
    }
    const Vertex vertex = ahead.ahead[index++];
    ahead.waits[vertex] = 0;
    if (ahead.visits[vertex] >= kVisits) continue;
    ++ahead.visits[vertex];
    beginEdits(o.work.room.log);
    const Point from = pointOf(state.mesh, vertex);
    const TriangleId firstId = state.mesh.nextId;
    const RelaxStep step = relaxVertex(o.work, vertex, limits, Flipping::where_obtuse);
    if (step.to == from) continue;
    if (step.moved && gatherLinks(state.mesh, vertex, ring)) {
      queueNext(o, vertex);
      for (const Vertex v : ring.neighbours()) queueNext(o, v);
    }
    return decideMoved(o, {.rule = Rule::relax,
                           .vertex = vertex,
                           .from = from,
                           .to = step.to,
                           .refusal = step.moved ? Refusal::none : Refusal::star_worse,
                           .measured = step.after,
                           .limit = step.before,
                           .firstId = firstId});
  }
}

Outcome decideKept(Optimiser& o, const EditReport& report, const EditMark& before) {
  MeshState& state = o.state;
  const Mesh& mesh = state.mesh;
  ++state.cursor.changes;
  StageCounts& counts = state.counts[state.stage];
  forEachSaved(o, before, [&](const EditLog::SavedVertex& saved) {
    if (isGone(mesh, saved.vertex))
      ++counts.removed;
    else if (pointOf(mesh, saved.vertex) != saved.at)
      ++counts.moved;
  });
  if (o.journal.listening()) {
    recordTouched(o, report, before);
    Event event = eventOf(o, EventKind::edit_kept, report);
    if (mesh.nextId > before.nextId) {
      event.created = before.nextId.n;
      event.createdCount = mesh.nextId.n - before.nextId.n;
    }
    o.journal.record(event);
  }
  if (mesh.points.size() == before.allVertices) return Outcome::decided;
  // One insertion, and one change, is counted by who carries the method on.
  counts.inserted += mesh.points.size() - before.allVertices - 1;
  --state.cursor.changes;
  return Outcome::inserted;
}

Outcome decideUndone(Optimiser& o, const EditReport& report) {
  ++o.state.counts[o.state.stage].refused;
  if (o.journal.listening()) o.journal.record(eventOf(o, EventKind::edit_undone, report));
  return Outcome::decided;
}

}  // namespace triscope
