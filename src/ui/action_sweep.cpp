// Which actions about sweeps over ω and θ can be done now, and why the others cannot.
#include "ui/view.h"

namespace triscope {

std::string whyNotSweep(Action action, const View& view) {
  const SweepUi& sweep = view.ui.sweep;
  if (infoOf(action).scope == Scope::heat_map) {
    if (!sweep.shown()) return "No sweep has been run yet.";
    if (action == Action::take_cell && !sweep.chosen) return "No pair of the sweep is chosen.";
    return {};
  }
  if (sweep.making) return "A sweep is running; Esc gives it up.";
  if (action == Action::save_sweep) {
    if (!sweep.table) return "No sweep has been run yet.";
    const bool holds = holdsFor(*sweep.table, view.session.domain(), view.session.settings());
    return holds ? "" : "The sweep is out of date; run it again.";
  }
  if (view.now() == nullptr) return "There is no mesh yet.";
  if (view.session.stale()) return "A new mesh is being made; wait, or press Esc to keep the old one.";
  if (!refines(view.session.settings()))
    return "Step 6 is switched off in Params: \xCF\x89 and \xCE\xB8 change nothing.";
  if (view.now()->state.failed) return "The method stopped here; change a parameter or the domain.";
  return {};
}

}  // namespace triscope
