// Runs the method for a command: in slices, so that progress can be shown in between.
#pragma once

#include <string>

#include "cli/notices.h"
#include "core/base/result.h"
#include "core/io/events_file.h"
#include "core/io/report.h"
#include "core/method/state.h"

namespace triscope {

/// Reads a domain and puts a state at its first stage. Says on stderr what was derived.
Result<MeshState> beginFile(const std::string& domainFile, const Settings& settings, Notices notices);

/// Carries the state on to the end of the stage `last`, or to where the method fails (state.failed), and returns how
/// long each stage took. Every decision goes to `events` when there is one. Errors: those of writing them.
Result<StageSeconds> carryOn(MeshState& state, Stage last, EventsFile* events, Notices notices);

/// Why and where the method could not go on.
Error failureOf(const MeshState& failed);

}  // namespace triscope
