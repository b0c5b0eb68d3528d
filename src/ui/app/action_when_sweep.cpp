// When what sweeps over ω and θ offer can be done.
#include "ui/app/action_when.h"

namespace triscope::when {
namespace {

constexpr const char* kRunning = "A sweep is running; Esc gives it up.";

}  // namespace

std::string sweeps(const RunView& view) {
  if (view.ui.sweep.making) return kRunning;
  if (std::string reason = holdsRun(view); !reason.empty()) return reason;
  if (!refines(view.session.settings()))
    return "Step 6 is switched off in Params: \xCF\x89 and \xCE\xB8 change nothing.";
  return view.now()->state.failed ? "The method stopped here; change a parameter or the domain." : "";
}

std::string savesSweep(const RunView& view) {
  const SweepUi& sweep = view.ui.sweep;
  if (sweep.making) return kRunning;
  if (!sweep.table) return "No sweep has been run yet.";
  const bool holds = holdsFor(*sweep.table, view.session.domain(), view.session.settings());
  return holds ? "" : "The sweep is out of date; run it again.";
}

std::string hasSweep(const RunView& view) { return view.ui.sweep.shown() ? "" : "No sweep has been run yet."; }

std::string takesCell(const RunView& view) {
  if (std::string reason = hasSweep(view); !reason.empty()) return reason;
  return view.ui.sweep.chosen ? "" : "No pair of the sweep is chosen.";
}

}  // namespace triscope::when
