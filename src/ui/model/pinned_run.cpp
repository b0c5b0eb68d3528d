#include "ui/model/pinned_run.h"

#include <utility>

namespace triscope {

PinnedRun::PinnedRun(std::shared_ptr<const Domain> domain, const Settings& settings, std::function<void()> wake)
    : session_(std::move(wake)), domain_(std::move(domain)) {
  renderer_.start();  // the same shaders as the live run's, which compiled
  session_.apply(command::Load{domain_, settings, {}});
}

bool PinnedRun::suits(const Domain& domain) const {
  return domain.name == domain_->name && domain.bounds.lo == domain_->bounds.lo &&
         domain.bounds.hi == domain_->bounds.hi;
}

void PinnedRun::follow(const Session& live) {
  const SnapshotPtr& now = live.current();
  if (now == nullptr || live.stale() || session_.current() == nullptr || session_.busy()) return;
  const bool complete = live.record().complete;
  const Compared compared{now->state.domain, now->state.settings, live.runEvents().size(), complete};
  if (compared_ != compared) {
    compared_ = compared;
    first_ = triscope::firstDifference(session_.runEvents(), live.runEvents());
    if (first_ && !complete && *first_ == live.runEvents().size()) first_.reset();  // B has not come to it yet
    place_.reset();
  }
  const RunPlace place{now->state.stage, now->state.tick, now->events};
  const Counterpart there = counterpart(place, live.record(), session_.record(), first_);
  if (place_ == there) return;
  place_ = there;
  if (there.begins)
    session_.apply(command::GoTo{*there.begins});
  else
    session_.apply(command::Seek{there.tick});
}

void PinnedRun::draw(ViewOptions options, const Camera& camera, double density) {
  scene_.theme = themeOf(options.theme);
  if (const SnapshotPtr& now = session_.current()) {
    options.dimmed = session_.stale();
    options.selection = {};  // ids are the live run's
    updateScene(scene_, now->state, options, now->last ? &*now->last : nullptr, &now->quality);
  }
  renderer_.draw(scene_, camera, density);
  texture_ = renderer_.texture();
}

}  // namespace triscope
