// The subcommands: each does what its options ask for, says what went wrong on stderr, and returns the exit code.
#pragma once

#include "cli/exit_codes.h"
#include "cli/options.h"
#include "core/base/result.h"

namespace triscope {

ExitCode runCommand(const WindowOptions& options);
ExitCode runCommand(const MeshCommand& options);
ExitCode runCommand(const CheckCommand& options);
ExitCode runCommand(const FigureCommand& options);
ExitCode runCommand(const SettingsCommand& options);
ExitCode runCommand(const DebugCommand& options);
ExitCode runCommand(const SweepCommand& options);
ExitCode runCommand(const ReplayCommand& options);

/// Prints an error as "triscope: …" on stderr and returns its exit code.
ExitCode fail(const Error& error);

}  // namespace triscope
