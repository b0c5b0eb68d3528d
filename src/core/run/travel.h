// Going about in a run, forwards and backwards. Each function puts the run back to a keyframe where the place lies
// behind it, and returns what is left to do: a goal to carry the run on to.
#pragma once

#include "core/run/goal.h"

namespace triscope {

/// To so many decisions. One at least is made again where the run has to go back, so that the last event is known.
Goal towardsTick(Run& run, std::uint64_t tick);
/// To right after the decision of event `index`, from 0.
Goal towardsEvent(Run& run, std::uint64_t index);
/// To where a stage begins, as it is known from the record of the run.
Goal towardsEntry(Run& run, const StageEntry& entry);
/// To where a stage begins for the first time.
Goal towardsStage(Run& run, Stage stage);
/// On by one grain.
Goal forward(const Run& run, Grain grain);
/// Back by one grain: a stage to its start, or that of the one before when the run is there already.
Goal back(Run& run, Grain grain);

}  // namespace triscope
