// The parts of the window: each owns its state and what is done to it, and all of them lie round one desk. They order
// and are told; none of them knows another unless it is given it here.
#pragma once

#include "render/gl_renderer.h"
#include "ui/app/comparison.h"
#include "ui/app/debugging.h"
#include "ui/app/density_editing.h"
#include "ui/app/desk.h"
#include "ui/app/document.h"
#include "ui/app/exporting.h"
#include "ui/app/insertion_walk.h"
#include "ui/app/keyboard.h"
#include "ui/app/legend_room.h"
#include "ui/app/modal_dialogs.h"
#include "ui/app/state_file.h"
#include "ui/app/styling.h"
#include "ui/app/sweeping.h"
#include "ui/app/tuning.h"
#include "ui/app/window.h"

namespace triscope {

struct Parts {
  Parts(const WindowOptions& options, std::function<void()> wake);

  Desk desk;
  Styling styling;
  Document document;
  InsertionWalk walk;
  Tuning tuning;
  DensityEditing density;
  Comparison comparison;
  Sweeping sweeping;
  Debugging debugging;
  Exporting exporting;
  ModalDialogs dialogs;
  Keyboard keyboard;
  LegendRoom legend;
  StateFile stateFile;
  std::unique_ptr<GlRenderer> renderer;  // while there is a context
  std::optional<Panel> wantedTab;        // to be brought to the front
  bool closing = false;
};

/// What panels, dialogs and regions look at.
View viewOf(Parts& parts);

/// Takes over what the session has published, until nothing that it leads to is left. True when something that is
/// shown has changed.
bool follow(Parts& parts);

}  // namespace triscope
