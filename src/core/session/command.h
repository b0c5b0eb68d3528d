// What a viewer may ask of a session. A later command takes the place of one still being carried out.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/method/pipeline.h"
#include "core/run/breakpoint.h"

namespace triscope {

namespace command {
struct OpenFile {
  std::string path;  // read, checked and meshed to the end; on an error the old mesh stays
};
struct OpenDomain {
  std::shared_ptr<const Domain> domain;  // already checked; meshed to the end
};
struct Load {
  std::shared_ptr<const Domain> domain;  // already checked; meshed to the end …
  Settings settings;                     // … with these
  std::optional<std::uint64_t> tick;     // then back to so many decisions
};
struct Change {
  Settings
      settings;  // re-meshes from the first stage that a difference can matter to, back to the same tick or the end
};
struct Advance {
  Grain grain = Grain::decision;
};
struct Seek {
  std::uint64_t tick = 0;  // decisions from the start; beyond the end is the end
};
struct StepBack {
  Grain grain = Grain::decision;  // stage: to its start, or that of the one before when already there
};
struct SeekEvent {
  std::uint64_t index = 0;  // to right after the decision that this event belongs to
};
struct SetBreakpoints {
  std::vector<Breakpoint> list;
};
struct Continue {
  bool backwards = false;  // to the next, or the last, decision that meets a breakpoint that stops; or the run's end
};
struct FindViolation {};  // to the first decision that breaks a bound or a validity rule; stays when there is none
struct GoTo {
  Stage stage = Stage::constraints;  // to where it begins for the first time, backwards or forwards
};
struct Restart {};
struct Play {
  double decisionsPerSecond = 60.0;
};
struct Pause {};   // stops where the run is
struct Cancel {};  // stops; a re-mesh not yet complete is given up for the mesh and the settings from before
}  // namespace command
using Command =
    std::variant<command::OpenFile, command::OpenDomain, command::Load, command::Change, command::Advance,
                 command::Seek, command::StepBack, command::SeekEvent, command::GoTo, command::Restart, command::Play,
                 command::Pause, command::Cancel, command::SetBreakpoints, command::Continue, command::FindViolation>;

}  // namespace triscope
