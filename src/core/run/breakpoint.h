// Breakpoints, and running to them: forwards from a state, backwards through a history.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/run/condition.h"
#include "core/run/history.h"

namespace triscope {

struct Breakpoint {
  enum class Action : std::uint8_t { stop, log, mark };
  Condition condition;
  Action action = Action::stop;
  bool enabled = true;
};
/// As sessions and the panel name the actions, in their order.
inline constexpr std::array<const char*, 3> kBreakpointActions{"stop", "log", "mark"};

/// A breakpoint that was met: right after decision `tick`.
struct Hit {
  std::uint64_t tick = 0;
  std::size_t breakpoint = 0;  // index into the list
  Event event;
  std::uint64_t number = 0;  // of the event in the run, from 0
};

/// Carries a state on one decision at a time and tells which breakpoints each decision meets. A condition on the mesh
/// alone is met when it becomes true; one that asks about events is met at each event that it holds for.
class Watch {
 public:
  /// `events` led to the state. The list of breakpoints stays the same from step to step.
  Watch(const MeshState& state, std::uint64_t events, std::span<const Breakpoint> breakpoints);

  /// One decision, a piece of the work for it (then nothing is met), or what follows the last one. False when the run
  /// is over. The hits of that decision, of every action, are in `hits`.
  bool step(MeshState& state, std::span<const Breakpoint> breakpoints, std::vector<Hit>& hits);

  /// Events of the last decision; none while it is being worked on.
  [[nodiscard]] std::span<const Event> events() const {
    return working_ ? std::span<const Event>() : std::span<const Event>(events_);
  }
  /// The first enabled breakpoint on the mesh alone whose condition held when the watch began: it is met when it next
  /// becomes true.
  [[nodiscard]] std::optional<std::size_t> heldFromStart() const { return heldFromStart_; }

 private:
  double shortestInput_;
  RunningQuality quality_;
  std::vector<Event> events_;
  std::uint64_t before_ = 0;        // events of the run before events_
  std::vector<std::uint8_t> held_;  // per breakpoint: its condition held before this decision
  std::optional<std::size_t> heldFromStart_;
  std::uint64_t sinceInsertion_ = 0;
  bool working_ = false;  // events_ are of a decision to come
};

/// Asked before each decision, or piece of one, that a search makes, with the state before it; false gives the search
/// up. May be empty.
using SearchPulse = std::function<bool(const MeshState&)>;

/// Carries the state on to the first decision that meets an enabled breakpoint whose action is stop; the state is then
/// right after that decision. Nothing when the run ends first, or the search is given up. Log and mark hits on the way
/// are appended to `passed`. Events are numbered from the state on.
std::optional<Hit> continueForward(MeshState& state, std::span<const Breakpoint> breakpoints, std::vector<Hit>& passed,
                                   const SearchPulse& pulse = {});

/// The last decision before `tick` that meets a breakpoint whose action is stop; nothing when there is none, or the
/// search is given up.
std::optional<Hit> continueBackward(const History& history, std::uint64_t tick, std::span<const Breakpoint> breakpoints,
                                    const SearchPulse& pulse = {});

/// A rule that no run should break: those of validity always, the bounds of section 3 once steps 1-5 are over.
struct ViolationRule {
  std::string_view condition;
  std::string_view words;  // "a triangle is turned over"
};
std::span<const ViolationRule> violationRules();
/// One for each of them, in their order.
std::vector<Breakpoint> violationBreakpoints();

}  // namespace triscope
