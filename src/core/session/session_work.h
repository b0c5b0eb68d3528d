// What goes on behind a session, without the thread: carries out commands, carries a run on in slices, and tells what
// there is to see. Whoever pumps it calls obey() for a command, and carrySlice() again and again while isUnderWay().
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/quality/quality_parts.h"
#include "core/run/driver.h"
#include "core/session/command.h"
#include "core/session/publication.h"

namespace triscope {

using CommandTest = std::function<bool(const Command&)>;

struct SessionWork {
  using Clock = std::chrono::steady_clock;

  /// The run from before a change, while the next one is being made: what is to be returned to when that is given up.
  struct SetAside {
    Run run;
    std::uint64_t kept = 0;
  };
  /// Playing: decisions that time earns, and has earned.
  struct Pace {
    double perSecond = 0.0;
    double owed = 1.0;  // the first at once
  };

  std::function<void(Publication)> tell;          // may be called from any of the functions below
  std::function<bool()> interrupted;              // a command waits: searches are to stop
  std::function<bool(const CommandTest&)> waits;  // whether a command waits that passes the test

  Driver driver;
  std::optional<SetAside> before;
  bool beginning = false;    // Δx of a run to come is being derived
  std::vector<Event> fresh;  // of driver.run.known events the viewer has the first `kept`, and these are the rest
  std::uint64_t kept = 0;
  std::optional<Pace> pace;           // while playing
  std::optional<std::uint64_t> then;  // decisions to go back to from the goal
  std::string heldFromStart;          // a condition that held where the watch began, which is no hit
  std::string notice;
  std::optional<Error> error;
  std::uint64_t failures = 0;
  std::uint64_t ordersDone = 0;
  std::uint64_t revision = 0;
  SnapshotPtr told;         // the last one, and its measures in parts: the next one is measured where they differ
  QualityInParts measured;  // of told
  Activity activity = Activity::idle;
  bool recordChanged = false;
  bool hitsChanged = false;
  std::uint64_t chunk = 64;  // beats in a slice, adapted to a few milliseconds
  Clock::time_point goalSince{};
  Clock::time_point lastSlice{};
  Clock::time_point lastTold{};
  Clock::time_point lastTrace{};
  Clock::duration tellingCost{};
};

/// Carries out a command, or sets out to. Where memory does not suffice the run is given up, and the error says so; as
/// in the next two.
void obey(SessionWork& work, const Command& command);

/// Whether there is a goal that the run has not come to.
bool isUnderWay(const SessionWork& work);
/// How long the next slice had better wait: playing, no decision may be due yet.
SessionWork::Clock::duration untilDue(const SessionWork& work);
/// Carries the run on for some milliseconds.
void carrySlice(SessionWork& work);

/// Whether measures along the run are still missing; carryTrace() finds some more, when there is nothing else to do.
bool traceLags(const SessionWork& work);
void carryTrace(SessionWork& work);

/// To be called when nothing has been asked for in a while.
void rest(const SessionWork& work);

}  // namespace triscope
