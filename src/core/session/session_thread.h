// The thread behind a Session. Commands go in, publications come out; nothing else is shared.
#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include "core/session/session_work.h"

namespace triscope {

class SessionThread {
 public:
  explicit SessionThread(std::function<void()> wake);
  ~SessionThread();
  SessionThread(const SessionThread&) = delete;
  SessionThread& operator=(const SessionThread&) = delete;

  void order(const Command& command);
  /// Nothing when nothing was published since the last call.
  std::optional<Publication> take();
  bool waitIdle(std::chrono::milliseconds patience);

 private:
  void loop();
  void sleep(std::unique_lock<std::mutex>& lock);
  void publish(Publication news);
  bool waits(const CommandTest& test);

  std::function<void()> wake_;

  // Shared, under mutex_.
  std::mutex mutex_;
  std::condition_variable inboxChanged_;
  std::condition_variable becameIdle_;
  std::deque<Command> inbox_;
  std::optional<Publication> outbox_;
  bool idle_ = true;
  bool quit_ = false;
  std::atomic<bool> interrupt_{false};  // a command waits

  SessionWork work_;    // the thread's own
  std::thread thread_;  // last: starts when everything above is ready
};

}  // namespace triscope
