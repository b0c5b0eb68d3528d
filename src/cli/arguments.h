// The command line, read into Options. The only user of CLI11.
#pragma once

#include <variant>

#include "cli/exit_codes.h"
#include "cli/options.h"
#include "core/base/result.h"

namespace triscope {

/// What to do; or how to exit at once, when help or the version was asked for and has been printed, or when the
/// command line is wrong and why has been said.
std::variant<Options, ExitCode> parseArguments(int argc, const char* const* argv);

}  // namespace triscope
