// triscope figure: draws any stage of a run without a display.
#include "render/figure.h"

#include <fmt/format.h>

#include "cli/carry_on.h"
#include "cli/commands.h"
#include "cli/messages.h"
#include "cli/outputs.h"

namespace triscope {
namespace {

Status checkFigures(const std::vector<std::string>& paths) {
  for (const std::string& path : paths) {
    if (!isFigurePath(path))
      return Error{.kind = ErrorKind::usage,
                   .message = "no picture format is known for this file name",
                   .hint = fmt::format("name it {}; 'triscope mesh' writes meshes", figureFormats()),
                   .file = path};
  }
  return success();
}

Status checkBox(const FigureCommand& options, const Box& domain) {
  const bool meets = !options.box || (options.box->lo.x < domain.hi.x && options.box->hi.x > domain.lo.x &&
                                      options.box->lo.y < domain.hi.y && options.box->hi.y > domain.lo.y);
  if (meets) return success();
  return Error{.kind = ErrorKind::usage,
               .message = "the part to draw lies outside the domain",
               .hint = fmt::format("the domain reaches from ({:.9g}, {:.9g}) to ({:.9g}, {:.9g})", domain.lo.x,
                                   domain.lo.y, domain.hi.x, domain.hi.y),
               .file = options.domain};
}

ViewOptions viewOf(const FigureCommand& options) {
  ViewOptions view = figureView(options.stage);
  if (options.dark) view.theme = ThemeKind::dark;
  if (options.cells) {
    view.quadtree = true;
    view.cells = *options.cells;
  }
  return view;
}

}  // namespace

ExitCode runCommand(const FigureCommand& options) {
  if (const Status known = checkFigures(options.outputs); !known.ok()) return fail(known.error());
  Result<MeshState> state = beginFile(options.domain, options.settings, options.notices);
  if (!state.ok()) return fail(state.error());
  if (const Status inside = checkBox(options, state->domain->bounds); !inside.ok()) return fail(inside.error());
  OutputSet files;
  if (const Status open = openOutputs(options.outputs, files); !open.ok()) return fail(open.error());

  if (const Result<StageSeconds> done = carryOn(*state, options.stage, nullptr, options.notices); !done.ok())
    return fail(done.error());
  if (state->failed) return fail(failureOf(*state));

  const ViewOptions view = viewOf(options);
  FigureOptions figure;
  figure.width = options.width;
  figure.height = options.height;
  figure.region = options.box;
  figure.title = figureTitle(*state, options.stage);
  figure.caption = figureCaption(*state, options.stage);
  for (const std::string& path : options.outputs) {
    const Result<std::string> picture = figureOf(path, *state, view, figure);
    if (!picture.ok()) return fail(picture.error());
    if (const Status written = files.write(path, *picture); !written.ok()) return fail(written.error());
  }
  if (const Status written = files.commit(); !written.ok()) return fail(written.error());
  if (options.notices == Notices::shown)
    for (const std::string& path : options.outputs) say("wrote {}\n", path);
  return ExitCode::ok;
}

}  // namespace triscope
