// A run under the eyes of a debugger: the state, every event up to it, and the history to go back by.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/debug/breakpoint.h"
#include "core/history/events.h"
#include "core/history/history.h"

namespace triscope {

class Recording {
 public:
  /// A state at tick 0. `budget` is that of the history, in bytes.
  explicit Recording(MeshState start, std::size_t budget = std::size_t{256} << 20);

  [[nodiscard]] const MeshState& state() const { return state_; }
  /// Events up to the state, oldest first.
  [[nodiscard]] const EventLog& events() const { return events_; }
  [[nodiscard]] const History& history() const { return history_; }
  [[nodiscard]] bool over() const { return state_.stage == Stage::finished; }

  /// Called now and then with the state; false stops the run where it is.
  using Pulse = std::function<bool(const MeshState&)>;
  void onPulse(Pulse pulse) { pulse_ = std::move(pulse); }

  // All of these go forwards or backwards, and return false when the place was not reached: it lies beyond the end, or
  // the pulse stopped the run.
  bool toEnd();
  bool toTick(std::uint64_t tick);
  /// Right after the decision of event `index`.
  bool toEvent(std::size_t index);
  /// Where the stage begins for the first time, before its first decision.
  bool toStage(Stage stage);

  /// To the first decision after here that meets a breakpoint whose action is stop; log and mark hits on the way are
  /// appended to `passed`. Ends at the end of the run when there is none.
  std::optional<Hit> toNextHit(std::span<const Breakpoint> breakpoints, std::vector<Hit>& passed);
  /// To the last decision before here that meets one; stays when there is none, or when the pulse gave the search up.
  std::optional<Hit> toPreviousHit(std::span<const Breakpoint> breakpoints);

  /// Number of the event that met the breakpoint, of a hit up to here.
  [[nodiscard]] std::size_t eventOf(const Hit& hit) const;

 private:
  template <class Reached>
  bool carryOn(Reached reached);
  void keepBeat();
  void returnTo(std::uint64_t tick);
  bool pulse(const MeshState& state);

  MeshState state_;
  EventLog events_;
  std::vector<Event> beat_;  // events not yet in the log
  History history_;
  Pulse pulse_;
  std::uint64_t beats_ = 0;
};

}  // namespace triscope
