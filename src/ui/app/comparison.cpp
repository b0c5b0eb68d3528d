#include "ui/app/comparison.h"

namespace triscope {

void Comparison::toggle() {
  if (pinned_) return letGo();
  pinned_ = std::make_unique<PinnedRun>(desk_.shown->state.domain, desk_.session.settings(), desk_.wake);
  desk_.ui.pinned = true;
  desk_.ui.debug.bottom = Panel::compare;
  desk_.ui.message = "This run is pinned as A. Change a parameter: B, beside it, follows.";
}

void Comparison::letGo() {
  pinned_.reset();
  desk_.ui.pinned = false;
  if (desk_.ui.debug.bottom == Panel::compare) desk_.ui.debug.bottom.reset();
}

void Comparison::follow() {
  if (!pinned_ || desk_.shown == nullptr) return;
  if (pinned_->suits(*desk_.shown->state.domain)) return pinned_->follow(desk_.session);
  letGo();
  desk_.ui.message = "Another domain: A is no longer pinned.";
}

void Comparison::draw(const ViewOptions& options) {
  if (pinned_) pinned_->draw(options, desk_.ui.camera, desk_.ui.scale());
}

}  // namespace triscope
