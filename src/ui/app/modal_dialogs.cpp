#include "ui/app/modal_dialogs.h"

#include "core/method/triangle_limit.h"
#include "ui/app/exporting.h"

namespace triscope {
namespace {

// A dialog is in its place, and its text field ready for keys, so many frames after the dialog was asked for.
constexpr int kFramesOfOpening = 3;

}  // namespace

void ModalDialogs::askWhatToOpen() {
  const Domain* const domain = shownDomain(desk_);
  open_.prepare(domain != nullptr ? domain->file : std::string());
  openDialog(desk_.ui, Dialog::open);
}

void ModalDialogs::askWhereToSave() {
  const std::string& path = desk_.ui.document.path;
  save_.prepare(path.empty() ? suggestedPath(desk_, ".session") : path);
  openDialog(desk_.ui, Dialog::save_as);
}

void ModalDialogs::askWhereToExport(const char* extension) {
  export_.prepare(suggestedPath(desk_, extension));
  openDialog(desk_.ui, Dialog::export_to);
}

void ModalDialogs::askAboutLimit() {
  if (asked_ != inForce(desk_)) asked_.reset();  // changed since: when it comes back to this it is a question again
  if (desk_.shown == nullptr || desk_.session.busy() || desk_.ui.dialog != Dialog::none) return;
  if (!overLimit(desk_.shown->state) || asked_) return;
  asked_ = inForce(desk_);
  limit_.prepare(desk_.shown->state);
  openDialog(desk_.ui, Dialog::limit);
}

void ModalDialogs::draw(const View& view, Orders& orders) {
  switch (desk_.ui.dialog) {
    case Dialog::none:
      break;
    case Dialog::open:
      open_.draw(view, orders);
      break;
    case Dialog::save_as:
      save_.draw(view, orders);
      break;
    case Dialog::export_to:
      export_.draw(view, orders);
      break;
    case Dialog::error:
      drawErrorDialog(view, orders);
      break;
    case Dialog::help:
      drawHelpDialog(view, orders);
      break;
    case Dialog::about:
      drawAboutDialog(view, orders);
      break;
    case Dialog::limit:
      limit_.draw(view, orders);
      break;
  }
}

void ModalDialogs::finishFrame() {
  framesDrawn_ = desk_.ui.dialog == drawn_ ? framesDrawn_ + 1 : 1;
  drawn_ = desk_.ui.dialog;
}

bool ModalDialogs::opening() const { return drawn_ != Dialog::none && framesDrawn_ < kFramesOfOpening; }

}  // namespace triscope
