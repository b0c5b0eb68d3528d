#include "core/debug/breakpoint.h"

#include <algorithm>

#include "core/debug/validity.h"

namespace triscope {

Watch::Watch(MeshState& state, std::span<const Breakpoint> breakpoints)
    : state_(state), breakpoints_(breakpoints), shortest_(shortestAllowed(state)), held_(breakpoints.size(), 0) {
  quality_.reset(state.mesh);
  const Event none;
  const Moment moment{state_, none, quality_, 0, 0};
  for (std::size_t k = 0; k < breakpoints_.size(); ++k) {
    const Condition& condition = breakpoints_[k].condition;
    held_[k] = !condition.asksOfEvents() && condition.holds(moment) ? 1 : 0;
  }
}

const Breakpoint* Watch::holding() const {
  for (std::size_t k = 0; k < breakpoints_.size(); ++k)
    if (breakpoints_[k].enabled && held_[k] != 0) return &breakpoints_[k];
  return nullptr;
}

bool Watch::step(std::vector<Hit>& hits) {
  if (!working_) events_.clear();
  changes_.slots.clear();
  const std::size_t points = state_.mesh.points.size();
  const std::uint64_t tick = state_.tick;
  Journal journal{&events_};
  const bool more = advanceAPiece(state_, journal);
  working_ = more && state_.tick == tick && state_.stage != Stage::finished;
  if (working_) return true;
  // What follows the last decision has events but no tick: the end of the last stage, or the failure of one.
  if (!more || events_.empty()) return false;
  quality_.update(state_.mesh, changes_.slots);
  sinceInsertion_ = state_.mesh.points.size() > points ? 0 : sinceInsertion_ + 1;
  const std::uint8_t broken = brokenRules(state_, changes_.slots, events_, shortest_);
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

bool goesOn(const SearchPulse& pulse, const MeshState& state) { return !pulse || pulse(state); }

}  // namespace

std::optional<Hit> continueForward(MeshState& state, std::span<const Breakpoint> breakpoints, std::vector<Hit>& passed,
                                   const SearchPulse& pulse) {
  Watch watch(state, breakpoints);
  std::vector<Hit> hits;
  while (goesOn(pulse, state) && watch.step(hits)) {
    for (const Hit& hit : hits) {
      if (breakpoints[hit.breakpoint].action != Breakpoint::Action::stop) passed.push_back(hit);
    }
    if (const std::optional<Hit> stop = stopAmong(hits, breakpoints)) return stop;
    hits.clear();
  }
  return std::nullopt;
}

std::optional<Hit> continueBackward(const History& history, std::uint64_t tick, std::span<const Breakpoint> breakpoints,
                                    const SearchPulse& pulse) {
  std::uint64_t end = tick;  // decisions up to `end` (not including the one that makes tick `end`) are looked at
  while (end > 1) {
    MeshState state = history.before(end - 2).state;  // the decision that makes tick end - 1 is made from there
    const std::uint64_t begin = state.tick;
    Watch watch(state, breakpoints);
    std::vector<Hit> hits;
    std::optional<Hit> last;
    while (state.tick + 1 < end) {
      if (!goesOn(pulse, state)) return std::nullopt;
      if (!watch.step(hits)) break;
      if (const std::optional<Hit> stop = stopAmong(hits, breakpoints)) last = stop;
      hits.clear();
    }
    if (last) return last;
    end = begin + 1;  // the decision that made the keyframe itself belongs to the stretch before
  }
  return std::nullopt;
}

std::span<const ViolationRule> violationRules() {
  static constexpr ViolationRule kRules[] = {
      {"orientation_broken", "a triangle is turned over"},
      {"delaunay_broken", "an edge is not Delaunay"},
      {"boundary_broken", "a boundary edge is gone"},
      {"balance_broken", "the quadtree is not balanced"},
      {"area_broken", "the triangles do not fill the domain"},
      {"edge_below_minimum", "an edge is shorter than Δx"},
      {"failed", "the method cannot go on"},
      {"bound_broken and (stage == refine or finished)", "a bound does not hold although the rounds are over"},
  };
  return kRules;
}

std::vector<Breakpoint> violationBreakpoints() {
  std::vector<Breakpoint> list;
  for (const ViolationRule& rule : violationRules()) list.push_back({std::move(*Condition::compile(rule.condition))});
  return list;
}

}  // namespace triscope
