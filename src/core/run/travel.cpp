#include "core/run/travel.h"

namespace triscope {
namespace {

/// What has not been yet lies behind the last keyframe of a run that was carried further than its state.
void toLastKeyframe(Run& run) {
  const Keyframe& last = run.history.before(kUnknown);
  if (last.state.tick > run.state.tick) returnTo(run, last);
}

}  // namespace

Goal towardsTick(Run& run, std::uint64_t tick) {
  const Keyframe& start = run.history.before(tick == 0 ? 0 : tick - 1);
  if (run.state.tick > tick || start.state.tick > run.state.tick) returnTo(run, start);
  run.history.aimAt(tick, run.state.tick);
  return {.kind = Goal::Kind::tick, .tick = tick};
}

Goal towardsEvent(Run& run, std::uint64_t index) {
  if (const std::optional<std::uint64_t> tick = run.recorder.tickOfEvent(index)) return towardsTick(run, *tick);
  toLastKeyframe(run);
  return {.kind = Goal::Kind::event, .event = index};
}

Goal towardsEntry(Run& run, const StageEntry& entry) {
  const Keyframe& start = run.history.before(entry.tick);
  if (run.events > entry.event || start.state.tick > run.state.tick) returnTo(run, start);
  run.history.aimAt(entry.tick, run.state.tick);
  return {.kind = Goal::Kind::entry, .tick = entry.tick, .stage = entry.stage, .round = entry.round};
}

Goal towardsStage(Run& run, Stage stage) {
  if (const StageEntry* const entry = firstEntry(run.recorder.record(), stage)) return towardsEntry(run, *entry);
  toLastKeyframe(run);
  return {.kind = Goal::Kind::entry, .tick = kUnknown, .stage = stage};
}

Goal forward(const Run& run, Grain grain) {
  Goal goal{.stage = run.state.stage, .round = run.state.round, .vertices = run.state.mesh.points.size()};
  switch (grain) {
    case Grain::decision:
      goal.kind = Goal::Kind::tick;
      goal.tick = run.state.tick + 1;
      break;
    case Grain::insertion:
      goal.kind = Goal::Kind::insertion;
      break;
    case Grain::stage:
      goal.kind = Goal::Kind::stage;
      break;
    case Grain::round:
      goal.kind = Goal::Kind::round;
      break;
    case Grain::all:
      goal.kind = Goal::Kind::end;
      break;
  }
  return goal;
}

Goal back(Run& run, Grain grain) {
  const std::uint64_t now = run.state.tick;
  if (grain == Grain::decision) return towardsTick(run, now == 0 ? 0 : now - 1);
  if (grain == Grain::insertion) return towardsTick(run, run.recorder.insertionBefore(now));
  const StageEntry* const entry = entryOfDecision(run.recorder.record(), now);
  if (entry == nullptr || entry->tick == 0) return towardsTick(run, 0);
  return towardsEntry(run, *entry);
}

}  // namespace triscope
