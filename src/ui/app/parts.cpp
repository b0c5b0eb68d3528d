#include "ui/app/parts.h"

#include <utility>

namespace triscope {
namespace {

/// What the session has to say: why a command failed, or what came of one that searched.
void hear(Desk& desk) {
  if (desk.session.failures() != desk.failuresSeen && desk.session.error()) complain(desk.ui, *desk.session.error());
  desk.failuresSeen = desk.session.failures();
  if (desk.session.notice() != desk.saidNotice) desk.ui.message = desk.saidNotice = desk.session.notice();
}

/// Nothing of the document before is left.
void beginDocument(Parts& parts) {
  parts.sweeping.cancel();
  parts.tuning.forget();
  parts.walk.forget();
  parts.debugging.forget();
  parts.density.forget();
  select(parts.desk.ui, {});
  parts.desk.ui.fitted = true;
  parts.document.begin();
}

void takeOver(Parts& parts) {
  Desk& desk = parts.desk;
  parts.document.follow();
  parts.density.follow();
  if (desk.session.current() == nullptr || desk.session.current() == desk.shown) return;
  desk.shown = desk.session.current();
  if (parts.document.isAnother()) beginDocument(parts);
  parts.tuning.follow();
  parts.debugging.keepInRange();
}

}  // namespace

Parts::Parts(const WindowOptions& options, std::function<void()> wake)
    : desk(std::move(wake)),
      styling(desk, options),
      document(desk, options.screenshot.empty() ? Autosave::defaultFolder() : std::string()),
      walk(desk),
      tuning(desk, document, walk),
      density(desk, tuning),
      comparison(desk),
      sweeping(desk),
      debugging(desk),
      exporting(desk),
      dialogs(desk),
      keyboard(desk),
      legend(desk),
      stateFile(options.stateFile) {}

View viewOf(Parts& parts) {
  return {{parts.desk.session, parts.desk.ui, parts.comparison.pinned()},
          parts.desk.scene,
          parts.styling.fonts(),
          parts.debugging.answers(),
          parts.renderer ? parts.renderer->texture() : 0,
          parts.desk.ui.legendOnCanvas,
          parts.stateFile.widgets(),
          parts.stateFile.tooltip()};
}

bool follow(Parts& parts) {
  const SnapshotPtr before = parts.desk.shown;
  do {
    hear(parts.desk);
    takeOver(parts);
    parts.walk.follow();
    parts.debugging.showFound();
  } while (parts.desk.shown != parts.desk.session.current());
  return parts.desk.shown != before;
}

}  // namespace triscope
