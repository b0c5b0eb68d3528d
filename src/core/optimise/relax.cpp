#include "core/optimise/relax.h"

#include <cmath>
#include <optional>

#include "core/mesh/slide.h"

namespace triscope {
namespace {

constexpr double kNothing = 1e-10;       // of a penalty
constexpr double kLongestStep = 0.2;     // in edge lengths wanted
constexpr double kShortestStep = 1e-14;  // squared
constexpr double kDamping = 0.02;
constexpr int kTries = 4;
constexpr double kShorter = 0.4;  // of the step before
constexpr double kFalls = 0.9999;
constexpr double kStalls = 0.95;  // a patch is left when a sweep leaves more of its penalty than this
constexpr int kSweeps = 4;        // that it has in any case

// A vertex that no rule may move has neither.
struct Way {
  Point by;
  double along = 0.0;              // of the curve's parameter
  std::optional<OnCurve> onCurve;  // of one that slides
};

Way wayInside(const StarPenalty& penalty, double size) {
  const double damping = kDamping * (penalty.xx + penalty.yy) + 1e-12 / (size * size);
  const double xx = penalty.xx + damping, yy = penalty.yy + damping, xy = penalty.xy;
  const double determinant = xx * yy - xy * xy;
  const Point slope = penalty.slope;
  return {{-(yy * slope.x - xy * slope.y) / determinant, -(xx * slope.y - xy * slope.x) / determinant}, 0.0, {}};
}

Way wayAlong(const StarPenalty& penalty, const Curve& curve, const OnCurve& place) {
  const Point tangent = derivativeAt(curve, place.t);
  const double curvature = penalty.xx * tangent.x * tangent.x + 2.0 * penalty.xy * tangent.x * tangent.y +
                           penalty.yy * tangent.y * tangent.y;
  if (!(curvature > 0.0)) return {};
  const double along = -dot(penalty.slope, tangent) / ((1.0 + kDamping) * curvature);
  return {along * tangent, along, place};
}

}  // namespace

RelaxStep relaxVertex(Workpiece& work, Vertex vertex, const PenaltyLimits& limits, Flipping flipping) {
  Mesh& mesh = work.mesh;
  OptimiserRoom& room = work.room;
  RelaxStep step;
  const bool border = mesh.vertexEdge[vertex].exists();
  const std::optional<OnCurve> place = border ? onCurve(mesh, vertex) : std::nullopt;
  if (border && !place) return step;
  if (!gatherRing(mesh, work.sizes, vertex, room.ring) || (!border && !room.ring.closed)) return step;
  const Point from = step.to = pointOf(mesh, vertex);
  const double size = work.sizes[vertex];
  StarPenalty penalty(mesh, room.ring, size, limits);
  step.before = step.after = penalty.withSlopeAt(from);
  if (step.before < kNothing) return step;
  const Way way = place ? wayAlong(penalty, work.curves[place->curve], *place) : wayInside(penalty, size);
  const double squaredWay = squaredLength(way.by);
  if (squaredWay < kShortestStep * size * size) return step;
  const double longest = kLongestStep * size;
  double scale = squaredWay > longest * longest ? longest / std::sqrt(squaredWay) : 1.0;
  for (int k = 0; k < kTries; ++k, scale *= kShorter) {
    Point to = from + scale * way.by;
    double t = 0.0;
    if (place) {
      t = place->t + scale * way.along;
      if (t <= mesh.edges[place->before].t0 || t >= mesh.edges[place->after].t1) continue;
      to = pointAt(work.curves[place->curve], t);
    }
    if (k == 0) step.to = to;
    const double after = penalty.at(to);
    if (!(after < kFalls * step.before)) continue;
    if (place)
      slideVertex(mesh, vertex, *place, t, to, room.log);
    else
      movePoint(mesh, vertex, to, room.log);
    noteRing(mesh, room.ring);
    step = {true, to, step.before, after};
    if (penalty.obtuse && flipping == Flipping::where_obtuse) {
      suspectStar(work, vertex);
      flipSuspects(work);
    }
    return step;
  }
  return step;
}

void relaxPatch(Workpiece& work, std::span<const Vertex> vertices, const PenaltyLimits& limits, Flipping flipping,
                int visits) {
  OptimiserRoom& room = work.room;
  const std::size_t count = work.mesh.points.size();
  room.inPatch.begin(count);
  room.queued.begin(count);
  room.queue.assign(vertices.begin(), vertices.end());
  for (const Vertex v : vertices) {
    room.inPatch.take(v);
    room.queued.take(v);
  }
  double last = 1e300;
  for (int sweep = 0; !room.queue.empty() && visits > 0; ++sweep) {
    room.nextQueue.clear();
    double sum = 0.0;
    for (const Vertex v : room.queue) {
      room.queued.forget(v);
      if (visits-- <= 0) break;
      const RelaxStep step = relaxVertex(work, v, limits, flipping);
      sum += step.before;
      if (!step.moved || !gatherLinks(work.mesh, v, room.ring)) continue;
      const auto put = [&](Vertex next) {
        if (room.inPatch.has(next) && room.queued.take(next)) room.nextQueue.push_back(next);
      };
      put(v);
      for (const Vertex next : room.ring.neighbours()) put(next);
    }
    if (sweep >= kSweeps && sum > kStalls * last) return;
    last = sum;
    room.queue.swap(room.nextQueue);
  }
}

}  // namespace triscope
