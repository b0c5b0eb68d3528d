// Recorded events from the first of the run on, so that an index is an event's number: a view, to be handed around.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "core/run/event_log.h"
#include "core/words/event.h"

namespace triscope {

/// Of a packed log or of a plain list, which must outlive it; see EventLog for what reading costs.
class Events {
 public:
  Events() = default;
  Events(const EventLog& log) : log_(&log), size_(log.size()) {}                    // NOLINT: a view
  Events(std::span<const Event> list) : list_(list), size_(list.size()) {}          // NOLINT
  Events(const std::vector<Event>& list) : Events(std::span<const Event>(list)) {}  // NOLINT

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  /// The first `count`, or all when there are no more.
  [[nodiscard]] Events first(std::size_t count) const {
    Events fewer = *this;
    fewer.size_ = std::min(count, size_);
    return fewer;
  }

  /// A whole event.
  [[nodiscard]] Event operator[](std::size_t index) const { return log_ != nullptr ? (*log_)[index] : list_[index]; }
  /// The event without Event::from: for looking through many. Valid until the next look.
  [[nodiscard]] const Event& peek(std::size_t index) const {
    return log_ != nullptr ? log_->peek(index) : list_[index];
  }

  /// The next event at or after `index` that is worth a look, by what its block mentions; see EventLog::next.
  template <class May>
  [[nodiscard]] std::size_t next(std::size_t index, const May& may) const {
    return log_ != nullptr ? log_->next(index, may) : index;
  }

 private:
  const EventLog* log_ = nullptr;
  std::span<const Event> list_;
  std::size_t size_ = 0;
};

}  // namespace triscope
