#include "core/session/session.h"

#include <algorithm>

#include "core/session/session_thread.h"

namespace triscope {

Session::Session(std::function<void()> wake) : worker_(std::make_unique<SessionThread>(std::move(wake))) {}

Session::~Session() = default;

void Session::apply(const Command& order) {
  ++orders_;
  if (const auto* change = std::get_if<command::Change>(&order)) {
    settings_ = change->settings;
    settingsOrder_ = orders_;
  }
  if (const auto* load = std::get_if<command::Load>(&order)) {
    settings_ = load->settings;
    domain_ = load->domain;
    settingsOrder_ = orders_;
  }
  if (const auto* set = std::get_if<command::SetBreakpoints>(&order)) breakpoints_ = set->list;
  worker_->order(order);
}

Events Session::events() const {
  return Events(events_).first(current_ ? static_cast<std::size_t>(current_->events) : 0);
}

bool Session::poll() {
  std::optional<Publication> news = worker_->take();
  if (!news) return false;
  if (news->snapshot) {
    current_ = std::move(news->snapshot);
    events_.truncate(static_cast<std::size_t>(news->keepEvents));
    events_.append(news->freshEvents);
  }
  if (news->record) record_ = std::move(news->record);
  if (news->hits) hits_ = std::move(news->hits);
  notice_ = std::move(news->notice);
  progress_ = news->progress;
  error_ = std::move(news->error);
  failures_ = news->failures;
  stale_ = news->stale;
  ordersDone_ = news->ordersDone;
  beforeRefinement_ = std::move(news->beforeRefinement);
  // The worker may have spoken before it heard of the latest change.
  if (ordersDone_ >= settingsOrder_) {
    settings_ = news->settings;
    domain_ = news->domain;
  }
  return true;
}

bool Session::settle(std::chrono::milliseconds patience) {
  const bool idle = worker_->waitIdle(patience);
  poll();
  return idle;
}

}  // namespace triscope
