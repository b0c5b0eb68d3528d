// triscope: the window, and subcommands over the same core.
#include <exception>
#include <new>

#include "cli/arguments.h"
#include "cli/command_files.h"
#include "cli/commands.h"
#include "cli/messages.h"
#include "core/base/stop.h"

namespace triscope {

ExitCode fail(const Error& error) {
  say("triscope: {}\n", describe(error));
  return exitCodeOf(error.kind);
}

namespace {

ExitCode runProgram(int argc, const char* const* argv) {
  const std::variant<Options, ExitCode> parsed = parseArguments(argc, argv);
  ExitCode code = ExitCode::ok;
  if (const ExitCode* const stop = std::get_if<ExitCode>(&parsed))
    code = *stop;
  else
    code = std::visit(
        [](const auto& options) {
          const Status files = checkFiles(filesOf(options));
          return files.ok() ? runCommand(options) : fail(files.error());
        },
        std::get<Options>(parsed));
  if (!endOfAnswers())
    return fail(Error{.kind = ErrorKind::cannot_write,
                      .message = "cannot write to the standard output",
                      .hint = "is the disk full, or the reader gone?"});
  return code;
}

ExitCode defect(const char* what) {
  say("triscope: internal error: {}\nThis is a defect of the program; please report it with the input.\n", what);
  return ExitCode::internal;
}

}  // namespace
}  // namespace triscope

int main(int argc, char** argv) {
  using namespace triscope;
  endOnSignals();
  holdStandardStreams();
  try {
    return static_cast<int>(runProgram(argc, argv));
  } catch (const std::bad_alloc&) {
    return static_cast<int>(fail(notEnoughMemory()));
  } catch (const std::exception& error) {
    return static_cast<int>(defect(error.what()));
  } catch (...) {
    return static_cast<int>(defect("an exception of unknown kind"));
  }
}
