// Which triangle slots the last edits wrote to, for those who follow a run closely. Off unless somebody listens.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace triscope {

/// While one lives, slots that get a new triangle, lose theirs, or have a corner moved are appended to it (possibly
/// several times) by the edits made on this thread. One at a time per thread; not part of any state.
class ChangeLog {
 public:
  ChangeLog() { listener_ = this; }
  ~ChangeLog() { listener_ = nullptr; }
  ChangeLog(const ChangeLog&) = delete;
  ChangeLog& operator=(const ChangeLog&) = delete;

  std::vector<std::int32_t> slots;

  static void note(std::int32_t slot) {
    if (listener_ != nullptr) listener_->slots.push_back(slot);
  }
  static void note(std::span<const std::int32_t> several) {
    if (listener_ != nullptr) listener_->slots.insert(listener_->slots.end(), several.begin(), several.end());
  }

  /// Edits on copies (patches tried out) are nobody's business: silences the log for a scope.
  class Pause {
   public:
    Pause() : paused_(listener_) { listener_ = nullptr; }
    ~Pause() { listener_ = paused_; }
    Pause(const Pause&) = delete;
    Pause& operator=(const Pause&) = delete;

   private:
    ChangeLog* paused_;
  };

 private:
  inline static thread_local ChangeLog* listener_ = nullptr;
};

}  // namespace triscope
