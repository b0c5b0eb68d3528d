// Which files each subcommand reads and writes: the one place that says so, for the check that none is overwritten.
#pragma once

#include <vector>

#include "cli/options.h"
#include "core/base/file_identity.h"

namespace triscope {

struct CommandFiles {
  std::vector<NamedFile> inputs;
  std::vector<NamedFile> outputs;
};

/// Refuses (usage) an output that is an input or another output, a standard stream that leads into either, and "-": the
/// standard output was meant, not a file called so. Where stderr is such a stream nothing is said there any more.
/// Inputs are kept from being cleared as what an earlier program left behind.
Status checkFiles(const CommandFiles& files);

CommandFiles filesOf(const WindowOptions& options);
CommandFiles filesOf(const MeshCommand& options);
CommandFiles filesOf(const CheckCommand& options);
CommandFiles filesOf(const FigureCommand& options);
CommandFiles filesOf(const SettingsCommand& options);
CommandFiles filesOf(const DebugCommand& options);
CommandFiles filesOf(const SweepCommand& options);
CommandFiles filesOf(const ReplayCommand& options);

}  // namespace triscope
