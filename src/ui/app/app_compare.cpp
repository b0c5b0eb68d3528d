// Two runs side by side: pinning A, and keeping it where B stands.
#include "ui/app/app.h"

namespace triscope {

void App::togglePinned() {
  if (pinned_) return unpin();
  pinned_ = std::make_unique<PinnedRun>(shown_->state.domain, session_.settings(), wake_);
  ui_.pinned = true;
  ui_.debug.bottom = Panel::compare;
  ui_.message = "This run is pinned as A. Change a parameter: B, beside it, follows.";
}

void App::unpin() {
  pinned_.reset();
  ui_.pinned = false;
  if (ui_.debug.bottom == Panel::compare) ui_.debug.bottom.reset();
}

void App::followPinned() {
  if (!pinned_ || shown_ == nullptr) return;
  if (pinned_->suits(*shown_->state.domain)) return pinned_->follow(session_);
  unpin();
  ui_.message = "Another domain: A is no longer pinned.";
}

}  // namespace triscope
