// Carries a run on to a goal, a slice at a time. It has no thread and no clock: who calls it decides when to look up.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/run/goal.h"

namespace triscope {

struct Driver {
  Run run;
  Goal goal;
  std::vector<Breakpoint> breakpoints;
  std::optional<Watch> watch;  // while the goal is a breakpoint
  std::optional<Hit> stopped;  // the breakpoint that ended the way to that goal
};

/// Sets out for a goal. Breakpoints that are watched for stay the same until the next call.
void headFor(Driver& driver, const Goal& goal);

/// Whether there is nothing more to do: the run is where the goal is, or over.
bool isThere(const Driver& driver);

/// Carries the run on to the goal, but for no more than so many beats (decisions, steps into the next stage, pieces of
/// the work for a decision), and not once `enough` says so: it is asked after what may have taken long, and may be
/// empty. Events that are new to the run are appended to `fresh`.
void carryOn(Driver& driver, std::uint64_t beats, const std::function<bool()>& enough, std::vector<Event>& fresh);

}  // namespace triscope
