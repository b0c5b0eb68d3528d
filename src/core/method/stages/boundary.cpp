// Stage "boundary" (paper, section 3, Figure 4 a): points on every curve so that each edge sees the same ∫ ds / h.
#include <algorithm>

#include "core/domain/loop_of.h"
#include "core/method/stages/stage_runs.h"

namespace triscope {
namespace {

constexpr double kShortestPart = 0.7;  // of Δx: an edge where lengths are continuous
constexpr int kByOne = 64;             // tries to place a curve's points with one edge less each time

struct Sample {
  double t;
  double integral;  // ∫ ds / h from the curve's start
};

// Trapezoids a quarter of the local edge length long.
void integrate(const MeshState& state, const Curve& curve, std::vector<Sample>& samples) {
  samples.assign(1, {0.0, 0.0});
  double t = 0.0;
  double integral = 0.0;
  LeafPath path;
  double h = edgeLengthAt(state.tree, curve.a, path);
  const double total = lengthBetween(curve, 0.0, 1.0);
  while (t < 1.0) {
    const double speed = std::max(length(derivativeAt(curve, t)), 1e-9 * total);
    double next = t + std::min(0.25 * h, total / 16.0) / speed;
    if (next > 1.0 - 1e-9) next = 1.0;
    const Point to = pointAt(curve, next);
    const double hNext = edgeLengthAt(state.tree, to, path);
    const double ds = curve.kind == CurveKind::line ? (next - t) * total : lengthBetween(curve, t, next);
    integral += 0.5 * ds * (1.0 / h + 1.0 / hNext);
    samples.push_back({next, integral});
    t = next;
    h = hNext;
  }
}

void place(const std::vector<Sample>& samples, int n, std::vector<double>& params) {
  params.assign(1, 0.0);
  std::size_t k = 0;
  for (int i = 1; i < n; ++i) {
    const double target = samples.back().integral * i / n;
    while (samples[k + 1].integral < target) ++k;
    const Sample& l = samples[k];
    const Sample& r = samples[k + 1];
    params.push_back(l.t + (r.t - l.t) * ((target - l.integral) / (r.integral - l.integral)));
  }
  params.push_back(1.0);
}

double shortestChord(const Curve& curve, const std::vector<double>& params) {
  double shortest = 1e300;
  for (std::size_t k = 0; k + 1 < params.size(); ++k) {
    shortest = std::min(shortest, squaredDistance(pointAt(curve, params[k]), pointAt(curve, params[k + 1])));
  }
  return std::sqrt(shortest);
}

// So many edges, of the length wanted each or of that times some ratio. Where the length is continuous the ratio
// nearest to 1 counts, which keeps it within 0.71 and 1.41; else, as in the paper, the nearest number.
int edgesFor(double integral, SizeField size) {
  if (size == SizeField::ranks) return static_cast<int>(std::floor(integral + 0.5));
  const double fewer = std::floor(integral);
  return static_cast<int>(integral * integral > fewer * (fewer + 1.0) ? fewer + 1.0 : fewer);
}

void placeOn(MeshState& state, std::uint32_t index, int fewest) {
  const Curve& curve = state.domain->curves[index];
  std::vector<Sample> samples;
  std::vector<double> params;
  integrate(state, curve, samples);
  int n = std::max(fewest, edgesFor(samples.back().integral, state.settings.size));
  const double shortestAllowed = state.minEdge * (state.settings.size == SizeField::continuous ? kShortestPart : 1.0);
  place(samples, n, params);
  // One edge less, and so on until none is too short; after many tries by what is missing, or a long curve would be
  // placed as often as it has edges.
  for (int tries = 0; n > fewest; ++tries) {
    const double shortest = shortestChord(curve, params);
    if (shortest >= shortestAllowed * (1.0 - 1e-9)) break;
    const int fewer = tries < kByOne ? n - 1 : std::min(n - 1, static_cast<int>(n * (shortest / shortestAllowed)));
    n = std::max(fewest, fewer);
    place(samples, n, params);
  }
  for (std::size_t k = 0; k < params.size(); ++k) {
    const bool end = k == 0 || k + 1 == params.size();
    const Point at = k == 0 ? curve.a : k + 1 == params.size() ? curve.b : pointAt(curve, params[k]);
    state.boundary.push_back({at, index, params[k], end, {}});
  }
}

// A closed loop needs three edges at least; a round one looks round from six.
int fewestEdges(const Loop& loop, const Curve& curve) {
  if (loop.role == LoopRole::chain) return 1;
  if (loop.curveCount == 1) return 6;
  if (loop.curveCount == 2) return 3;
  return curve.kind == CurveKind::arc && std::fabs(curve.sweptAngle) > 1.6 ? 2 : 1;
}

}  // namespace

Outcome runBoundary(MeshState& state, Journal& journal) {
  // index: points shown so far; phase: curves done. Loops list their curves in order.
  Cursor& cursor = state.cursor;
  cursor.begun = true;
  while (cursor.index == state.boundary.size()) {
    if (cursor.phase == state.domain->curves.size()) return Outcome::done;
    const Loop& loop = loopOf(*state.domain, cursor.phase);
    placeOn(state, cursor.phase, fewestEdges(loop, state.domain->curves[cursor.phase]));
    ++cursor.phase;
  }
  const BoundaryPoint& point = state.boundary[cursor.index++];
  if (journal.listening()) {
    Event event = eventIn(state, EventKind::boundary_point, Rule::boundary_point);
    event.subject = point.curve;
    event.other = static_cast<std::uint32_t>(cursor.index - 1);
    event.measured = edgeLengthAt(state.tree, point.at);
    event.limit = state.minEdge;
    event.at = point.at;
    journal.record(event);
  }
  return Outcome::decided;
}

}  // namespace triscope
