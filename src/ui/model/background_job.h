// One piece of work at a time, away from the window's thread.
#pragma once

#include <atomic>
#include <functional>
#include <new>
#include <optional>
#include <thread>
#include <utility>

#include "core/base/result.h"

namespace triscope {

class BackgroundJob {
 public:
  BackgroundJob() = default;
  ~BackgroundJob() { wait(); }
  BackgroundJob(const BackgroundJob&) = delete;
  BackgroundJob& operator=(const BackgroundJob&) = delete;

  /// Must not be called while running(). `wake` is called from the other thread when `work` is done.
  void start(std::function<Status()> work, std::function<void()> wake) {
    wait();
    done_ = false;
    running_ = true;
    thread_ = std::thread([this, work = std::move(work), wake = std::move(wake)] {
      try {
        result_ = work();
      } catch (const std::bad_alloc&) {
        result_ = notEnoughMemory();
      }
      done_ = true;
      wake();
    });
  }
  /// Until it is done, if there is one; finished() still tells of it.
  void wait() {
    if (thread_.joinable()) thread_.join();
  }
  [[nodiscard]] bool running() const { return running_; }
  [[nodiscard]] bool ready() const { return running_ && done_; }
  /// The outcome, once, when there is one.
  std::optional<Status> finished() {
    if (!ready()) return std::nullopt;
    wait();
    running_ = false;
    return std::exchange(result_, std::nullopt);
  }

 private:
  std::thread thread_;
  std::atomic<bool> done_{false};
  std::optional<Status> result_;
  bool running_ = false;
};

}  // namespace triscope
