// The exit codes of the program (sysexits where they fit), and what they mean, for --help; README.md has the same table
// with more words. What ends it by a signal is in core/base/stop.h.
#pragma once

#include <string>

#include "core/base/result.h"

namespace triscope {

enum class ExitCode : int {
  ok = 0,
  unmet = 1,
  usage = 2,
  bad_data = 65,
  no_input = 66,
  no_display = 69,
  internal = 70,
  no_memory = 71,
  cannot_write = 73,
  cancelled = 130,
};

/// What the program ends with when it fails so.
ExitCode exitCodeOf(ErrorKind kind);

/// One a line, under a heading.
std::string exitCodesHelp();

}  // namespace triscope
