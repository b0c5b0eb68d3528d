#include "core/run/goal.h"

namespace triscope {

bool arrived(const Run& run, const Goal& goal) {
  const MeshState& state = run.state;
  switch (goal.kind) {
    case Goal::Kind::none:
      return true;
    case Goal::Kind::tick:
      return state.tick >= goal.tick;
    case Goal::Kind::event: {
      if (run.events <= goal.event) return false;
      // What follows the last decision belongs to none.
      const std::optional<std::uint64_t> tick = run.recorder.tickOfEvent(goal.event);
      return tick ? *tick <= state.tick : isOver(run);
    }
    case Goal::Kind::entry:
      if (goal.tick == kUnknown) return state.stage >= goal.stage;  // it may be left out
      return state.tick > goal.tick ||
             (state.tick == goal.tick && state.stage == goal.stage && state.round == goal.round);
    case Goal::Kind::insertion:
      return state.mesh.points.size() > goal.vertices;
    case Goal::Kind::stage:
      return state.stage != goal.stage;
    case Goal::Kind::round:
      return state.round != goal.round || (goal.round == 0 && state.stage != goal.stage);
    case Goal::Kind::breakpoint:
      return false;
    case Goal::Kind::end:
      return isOver(run);
  }
  return true;
}

}  // namespace triscope
