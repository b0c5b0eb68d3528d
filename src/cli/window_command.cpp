// triscope [FILE]: the window.
#include "cli/commands.h"

#if TRISCOPE_WINDOW

namespace triscope {

ExitCode runCommand(const WindowOptions& options) {
  const Status end = runWindow(options);
  return end.ok() ? ExitCode::ok : fail(end.error());
}

}  // namespace triscope

#else

namespace triscope {

ExitCode runCommand(const WindowOptions&) {
  return fail(Error{.kind = ErrorKind::no_display,
                    .message = "this program was built without its window",
                    .hint = "use a subcommand ('triscope --help'), or build with TRISCOPE_WINDOW=ON"});
}

}  // namespace triscope

#endif
