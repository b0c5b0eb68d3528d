#include "core/run/breakpoint.h"

#include "core/base/assert.h"
#include "core/mesh/change_log.h"
#include "core/run/validity.h"

namespace triscope {

Watch::Watch(const MeshState& state, std::uint64_t events, std::span<const Breakpoint> breakpoints)
    : shortestInput_(shortestInput(state)), before_(events), held_(breakpoints.size(), 0) {
  quality_.reset(state.mesh);
  const Event none;
  const Moment moment{state, none, quality_, 0, 0};
  for (std::size_t k = 0; k < breakpoints.size(); ++k) {
    const Condition& condition = breakpoints[k].condition;
    held_[k] = !condition.asksOfEvents() && condition.holds(moment) ? 1 : 0;
    if (held_[k] != 0 && breakpoints[k].enabled && !heldFromStart_) heldFromStart_ = k;
  }
}

bool Watch::step(MeshState& state, std::span<const Breakpoint> breakpoints, std::vector<Hit>& hits) {
  TRISCOPE_CHECK(breakpoints.size() == held_.size(), "the breakpoints that are watched for stay the same");
  if (!working_) {
    before_ += events_.size();
    events_.clear();
  }
  const ChangeLog changes(state.mesh);
  const std::size_t points = state.mesh.points.size();
  const std::uint64_t tick = state.tick;
  Journal journal{&events_};
  const bool more = advanceAPiece(state, journal);
  working_ = more && state.tick == tick && state.stage != Stage::finished && !state.failed;
  if (working_) return true;
  // What follows the last decision has events but no tick: the end of the last stage, or the failure of one.
  if (!more || events_.empty()) return false;
  quality_.update(state.mesh, changes.slots());
  sinceInsertion_ = state.mesh.points.size() > points ? 0 : sinceInsertion_ + 1;
  const std::uint8_t broken = brokenRules(state, changes.slots(), events_, shortestInput_);
  for (std::size_t k = 0; k < breakpoints.size(); ++k) {
    if (!breakpoints[k].enabled) continue;
    const Condition& condition = breakpoints[k].condition;
    if (!condition.asksOfEvents()) {
      const bool holds = condition.holds({state, events_.back(), quality_, sinceInsertion_, broken});
      if (holds && held_[k] == 0) hits.push_back({state.tick, k, events_.back(), before_ + events_.size() - 1});
      held_[k] = holds ? 1 : 0;
      continue;
    }
    for (std::size_t e = 0; e < events_.size(); ++e) {
      if (!condition.holds({state, events_[e], quality_, sinceInsertion_, broken})) continue;
      hits.push_back({state.tick, k, events_[e], before_ + e});
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
  Watch watch(state, 0, breakpoints);
  std::vector<Hit> hits;
  while (goesOn(pulse, state) && watch.step(state, breakpoints, hits)) {
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
    MeshState state = history.stateBefore(end - 2);  // the decision that makes tick end - 1 is made from there
    const std::uint64_t begin = state.tick;
    Watch watch(state, history.before(end - 2).events, breakpoints);
    std::vector<Hit> hits;
    std::optional<Hit> last;
    while (state.tick + 1 < end) {
      if (!goesOn(pulse, state)) return std::nullopt;
      if (!watch.step(state, breakpoints, hits)) break;
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
