// A run that stopped because of Settings::maxTriangles: the window asks once what is to be done.
#include "core/method/triangle_limit.h"
#include "ui/app/app.h"

namespace triscope {

void App::askAboutLimit() {
  if (asked_ != inForce()) asked_.reset();  // changed since: when it comes back to this it is a question again
  // Not while a control is held: where it is let go decides.
  if (shown_ == nullptr || session_.busy() || tuning_ || ui_.dialog != Dialog::none) return;
  if (!overLimit(shown_->state) || asked_) return;
  asked_ = inForce();
  limitDialog_.prepare(shown_->state);
  openDialog(Dialog::limit);
}

}  // namespace triscope
