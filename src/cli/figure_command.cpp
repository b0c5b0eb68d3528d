// triscope figure: draws any stage of a run without a display.
#include "render/figure.h"

#include <fmt/format.h>

#include "cli/carry_on.h"
#include "cli/commands.h"
#include "cli/interrupt.h"
#include "cli/outputs.h"

namespace triscope {
namespace {

Status checkFigures(const std::vector<std::string>& paths) {
  for (const std::string& path : paths) {
    if (!isFigurePath(path))
      return Error{.code = ExitCode::usage,
                   .message = "no picture format is known for this file name",
                   .hint = fmt::format("name it {}; 'triscope mesh' writes meshes", figureFormats()),
                   .file = path};
  }
  return success();
}

}  // namespace

ExitCode runCommand(const FigureCommand& options) {
  if (const Status known = checkFigures(options.outputs); !known.ok()) return fail(known.error());
  watchForInterrupt();
  Result<MeshState> state = beginFile(options.domain, options.settings, options.quiet);
  if (!state.ok()) return fail(state.error());
  if (const Status writable = probeOutputs(options.outputs); !writable.ok()) return fail(writable.error());

  if (const Result<StageSeconds> done = carryOn(*state, options.stage, nullptr, options.quiet); !done.ok())
    return fail(done.error());
  if (state->failed) return fail(failureOf(*state));

  ViewOptions view = figureView(options.stage);
  if (options.dark) view.theme = ThemeKind::dark;
  FigureOptions figure;
  figure.width = options.width;
  figure.height = options.height;
  figure.title = figureTitle(*state, options.stage);
  figure.caption = figureCaption(*state, options.stage);
  for (const std::string& path : options.outputs) {
    if (const Status written = writeFigure(path, *state, view, figure); !written.ok()) return fail(written.error());
    if (!options.quiet) fmt::print(stderr, "wrote {}\n", path);
  }
  return ExitCode::ok;
}

}  // namespace triscope
