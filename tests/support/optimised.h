// Settings for tests of the placements and of the optimiser.
#pragma once

#include "core/words/preset.h"

namespace triscope::support {

/// The preset "best", at its first mark.
inline Settings best(Dial dial = Dial::easy) {
  Settings settings;
  static_cast<void>(applyPreset(settings, "best"));
  settings.dial = dial;
  return settings;
}

/// The standard method, optimised.
inline Settings optimised(Dial dial = Dial::easy) {
  Settings settings;
  settings.optimise = true;
  settings.dial = dial;
  return settings;
}

/// Rows of a placement, not optimised: the rounds of steps 2 to 5 follow.
inline Settings rowsOf(Placement placement) {
  Settings settings = best();
  settings.placement = placement;
  settings.optimise = false;
  return settings;
}

}  // namespace triscope::support
