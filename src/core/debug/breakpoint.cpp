#include "core/debug/breakpoint.h"

#include <algorithm>
#include <string_view>

#include "core/geometry/predicates.h"
#include "core/mesh/edit.h"
#include "core/mesh/flip.h"

namespace triscope {

Watch::Watch(MeshState& state, std::span<const Breakpoint> breakpoints)
    : state_(state), breakpoints_(breakpoints), shortest_(state.minEdge), held_(breakpoints.size(), 0) {
  for (const Curve& curve : state.domain->curves) {
    if (curve.kind == CurveKind::line) shortest_ = std::min(shortest_, distance(curve.a, curve.b));
  }
  quality_.reset(state.mesh);
  const Event none;
  const Moment moment{state_, none, quality_, 0, 0};
  for (std::size_t k = 0; k < breakpoints_.size(); ++k) {
    const Condition& condition = breakpoints_[k].condition;
    held_[k] = !condition.asksOfEvents() && condition.holds(moment) ? 1 : 0;
  }
}

std::uint8_t Watch::brokenNow() const {
  const Mesh& mesh = state_.mesh;
  std::uint8_t broken = 0;
  // Before the carving edges may run outside the domain, across a thin part of it.
  const double shortest = state_.stage > Stage::carve ? shortest_ * shortest_ * (1.0 - 1e-9) : 0.0;
  for (const std::int32_t slot : changes_.slots) {
    if (!mesh.alive(slot)) continue;
    const Triangle& t = triangleAt(mesh, slot);
    if (orient2d(pointOf(mesh, t.v[0]), pointOf(mesh, t.v[1]), pointOf(mesh, t.v[2])) <= 0) broken |= kOrientation;
    for (int i = 0; i < 3; ++i) {
      const std::int32_t half = 3 * slot + i;
      if (flipWanted(mesh, half)) broken |= kDelaunay;
      // Edges between points that the input fixes are as long as the input makes them.
      const std::int32_t a = startOf(mesh, half), b = endOf(mesh, half);
      const bool fixed = mesh.kinds[at(a)] <= VertexKind::kept && mesh.kinds[at(b)] <= VertexKind::kept;
      if (!fixed && squaredDistance(pointOf(mesh, a), pointOf(mesh, b)) < shortest) broken |= kMinimumLength;
    }
  }
  return broken;
}

bool Watch::step(std::vector<Hit>& hits) {
  events_.clear();
  changes_.slots.clear();
  const std::size_t points = state_.mesh.points.size();
  Journal journal{&events_};
  // What follows the last decision has events but no tick: the end of the last stage, or the failure of one.
  if (!advance(state_, Grain::decision, journal) || events_.empty()) return false;
  quality_.update(state_.mesh, changes_.slots);
  sinceInsertion_ = state_.mesh.points.size() > points ? 0 : sinceInsertion_ + 1;
  const std::uint8_t broken = brokenNow();
  for (std::size_t k = 0; k < breakpoints_.size(); ++k) {
    if (!breakpoints_[k].enabled) continue;
    const Condition& condition = breakpoints_[k].condition;
    if (!condition.asksOfEvents()) {
      const bool holds = condition.holds({state_, events_.back(), quality_, sinceInsertion_, broken});
      if (holds && held_[k] == 0) hits.push_back({state_.tick, k, events_.back()});
      held_[k] = holds ? 1 : 0;
      continue;
    }
    for (const Event& event : events_) {
      if (!condition.holds({state_, event, quality_, sinceInsertion_, broken})) continue;
      hits.push_back({state_.tick, k, event});
      break;
    }
  }
  return true;
}

namespace {

// First hit of the last decision that stops; the others are passed by.
std::optional<Hit> stopAmong(const std::vector<Hit>& hits, std::span<const Breakpoint> breakpoints) {
  for (const Hit& hit : hits) {
    if (breakpoints[hit.breakpoint].action == Breakpoint::Action::stop) return hit;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Hit> continueForward(MeshState& state, std::span<const Breakpoint> breakpoints, std::vector<Hit>& passed,
                                   const std::atomic<bool>& cancel) {
  Watch watch(state, breakpoints);
  std::vector<Hit> hits;
  while (!cancel.load(std::memory_order_relaxed) && watch.step(hits)) {
    for (const Hit& hit : hits) {
      if (breakpoints[hit.breakpoint].action != Breakpoint::Action::stop) passed.push_back(hit);
    }
    if (const std::optional<Hit> stop = stopAmong(hits, breakpoints)) return stop;
    hits.clear();
  }
  return std::nullopt;
}

std::optional<Hit> continueBackward(const History& history, std::uint64_t tick, std::span<const Breakpoint> breakpoints,
                                    const std::atomic<bool>& cancel) {
  std::uint64_t end = tick;  // decisions up to `end` (not including the one that makes tick `end`) are looked at
  while (end > 1) {
    MeshState state = history.before(end - 2).state;  // the decision that makes tick end - 1 is made from there
    const std::uint64_t begin = state.tick;
    Watch watch(state, breakpoints);
    std::vector<Hit> hits;
    std::optional<Hit> last;
    while (state.tick + 1 < end && !cancel.load(std::memory_order_relaxed) && watch.step(hits)) {
      if (const std::optional<Hit> stop = stopAmong(hits, breakpoints)) last = stop;
      hits.clear();
    }
    if (last || cancel.load(std::memory_order_relaxed)) return last;
    end = begin + 1;  // the decision that made the keyframe itself belongs to the stretch before
  }
  return std::nullopt;
}

std::vector<Breakpoint> violationBreakpoints() {
  constexpr std::string_view texts[] = {
      "orientation_broken",
      "delaunay_broken",
      "edge_below_minimum",
      "failed",
      "bound_broken and (stage == refine or finished)",
  };
  std::vector<Breakpoint> list;
  for (const std::string_view text : texts) {
    Result<Condition> condition = Condition::compile(text);
    list.push_back({std::move(*condition)});
  }
  return list;
}

}  // namespace triscope
