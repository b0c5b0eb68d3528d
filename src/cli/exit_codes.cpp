#include "cli/exit_codes.h"

#include <fmt/format.h>

#include <array>
#include <csignal>
#include <iterator>
#include <optional>
#include <string_view>

namespace triscope {
namespace {

struct Meaning {
  int code;
  std::string_view words;
  std::optional<ErrorKind> kind{};  // of the error that ends the program so
};

constexpr Meaning of(ExitCode code, std::string_view words, std::optional<ErrorKind> kind = {}) {
  return {static_cast<int>(code), words, kind};
}

constexpr int kBySignal = 128;  // more than the number of the signal, as shells have it

constexpr std::array kMeanings{
    of(ExitCode::ok, "done"),
    of(ExitCode::unmet,
       "a bound is not met, a mesh is not valid, a session is not as recorded, or the method could not go on",
       ErrorKind::unmet),
    of(ExitCode::usage, "the command line is wrong", ErrorKind::usage),
    of(ExitCode::bad_data, "the input is wrong, or asks for more triangles than --max-triangles", ErrorKind::bad_data),
    of(ExitCode::no_input, "the input cannot be opened", ErrorKind::no_input),
    of(ExitCode::no_display, "no window can be opened here", ErrorKind::no_display),
    of(ExitCode::internal, "a defect of the program", ErrorKind::internal),
    of(ExitCode::no_memory, "not enough memory", ErrorKind::no_memory),
    of(ExitCode::cannot_write, "an output cannot be written", ErrorKind::cannot_write),
    Meaning{kBySignal + SIGHUP, "stopped, the terminal is gone"},
    of(ExitCode::cancelled, "stopped by Ctrl+C", ErrorKind::cancelled),
    Meaning{kBySignal + SIGPIPE, "stopped, nobody reads a pipe any more"},
    Meaning{kBySignal + SIGTERM, "stopped by TERM"},
};

}  // namespace

ExitCode exitCodeOf(ErrorKind kind) {
  for (const Meaning& meaning : kMeanings)
    if (meaning.kind == kind) return static_cast<ExitCode>(meaning.code);
  return ExitCode::internal;
}

std::string exitCodesHelp() {
  std::string text = "Exit codes:\n";
  for (const Meaning& meaning : kMeanings)
    fmt::format_to(std::back_inserter(text), "  {:<5}{}\n", meaning.code, meaning.words);
  return text;
}

}  // namespace triscope
