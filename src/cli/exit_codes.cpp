#include "cli/exit_codes.h"

#include <fmt/format.h>

#include <array>
#include <csignal>
#include <iterator>
#include <string_view>

namespace triscope {
namespace {

struct Meaning {
  int code;
  std::string_view words;
};

constexpr Meaning of(ExitCode code, std::string_view words) { return {static_cast<int>(code), words}; }

constexpr int kBySignal = 128;  // more than the number of the signal, as shells have it

constexpr std::array kMeanings{
    of(ExitCode::ok, "done"),
    of(ExitCode::unmet,
       "a bound is not met, a mesh is not valid, a session is not as recorded, or the method could not go on"),
    of(ExitCode::usage, "the command line is wrong"),
    of(ExitCode::bad_data, "the input is wrong, or asks for more triangles than --max-triangles"),
    of(ExitCode::no_input, "the input cannot be opened"),
    of(ExitCode::no_display, "no window can be opened here"),
    of(ExitCode::internal, "a defect of the program"),
    of(ExitCode::no_memory, "not enough memory"),
    of(ExitCode::cannot_write, "an output cannot be written"),
    Meaning{kBySignal + SIGHUP, "stopped, the terminal is gone"},
    of(ExitCode::cancelled, "stopped by Ctrl+C"),
    Meaning{kBySignal + SIGPIPE, "stopped, nobody reads a pipe any more"},
    Meaning{kBySignal + SIGTERM, "stopped by TERM"},
};

}  // namespace

ExitCode exitCodeOf(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::bad_data:
      return ExitCode::bad_data;
    case ErrorKind::no_input:
      return ExitCode::no_input;
    case ErrorKind::cannot_write:
      return ExitCode::cannot_write;
    case ErrorKind::usage:
      return ExitCode::usage;
    case ErrorKind::unmet:
      return ExitCode::unmet;
    case ErrorKind::no_display:
      return ExitCode::no_display;
    case ErrorKind::no_memory:
      return ExitCode::no_memory;
    case ErrorKind::cancelled:
      return ExitCode::cancelled;
    case ErrorKind::internal:
      break;
  }
  return ExitCode::internal;
}

std::string exitCodesHelp() {
  std::string text = "Exit codes:\n";
  for (const Meaning& meaning : kMeanings)
    fmt::format_to(std::back_inserter(text), "  {:<5}{}\n", meaning.code, meaning.words);
  return text;
}

}  // namespace triscope
