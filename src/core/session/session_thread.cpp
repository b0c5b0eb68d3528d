#include "core/session/session_thread.h"

#include <algorithm>
#include <utility>

namespace triscope {

SessionThread::SessionThread(std::function<void()> wake) : wake_(std::move(wake)) {
  work_.tell = [this](Publication news) { publish(std::move(news)); };
  work_.interrupted = [this] { return interrupt_.load(std::memory_order_relaxed); };
  work_.waits = [this](const CommandTest& test) { return waits(test); };
  thread_ = std::thread([this] { loop(); });
}

SessionThread::~SessionThread() {
  {
    const std::lock_guard lock(mutex_);
    quit_ = true;
    interrupt_ = true;
  }
  inboxChanged_.notify_one();
  thread_.join();
}

void SessionThread::order(const Command& command) {
  {
    const std::lock_guard lock(mutex_);
    inbox_.push_back(command);
    interrupt_ = true;
    idle_ = false;
  }
  inboxChanged_.notify_one();
}

std::optional<Publication> SessionThread::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(outbox_, std::nullopt);
}

bool SessionThread::waitIdle(std::chrono::milliseconds patience) {
  std::unique_lock lock(mutex_);
  return becameIdle_.wait_for(lock, patience, [this] { return idle_; });
}

bool SessionThread::waits(const CommandTest& test) {
  const std::lock_guard lock(mutex_);
  return quit_ || std::any_of(inbox_.begin(), inbox_.end(), test);
}

void SessionThread::publish(Publication news) {
  {
    const std::lock_guard lock(mutex_);
    if (outbox_)
      add(*outbox_, std::move(news));
    else
      outbox_ = std::move(news);
  }
  if (wake_) wake_();
}

void SessionThread::sleep(std::unique_lock<std::mutex>& lock) {
  constexpr auto kWhile = std::chrono::seconds(2);
  const auto wanted = [this] { return quit_ || !inbox_.empty(); };
  if (inboxChanged_.wait_for(lock, kWhile, wanted)) return;
  lock.unlock();
  rest(work_);
  lock.lock();
  inboxChanged_.wait(lock, wanted);
}

void SessionThread::loop() {
  std::unique_lock lock(mutex_);
  const auto unlocked = [&lock](const auto& does) {
    lock.unlock();
    does();
    lock.lock();
  };
  while (!quit_) {
    if (!inbox_.empty()) {
      const Command command = std::move(inbox_.front());
      inbox_.pop_front();
      interrupt_ = !inbox_.empty();
      unlocked([&] { obey(work_, command); });
    } else if (isUnderWay(work_)) {
      const auto pause = untilDue(work_);
      if (pause > pause.zero()) inboxChanged_.wait_for(lock, pause, [this] { return quit_ || !inbox_.empty(); });
      unlocked([this] { carrySlice(work_); });
    } else {
      idle_ = true;
      becameIdle_.notify_all();
      if (traceLags(work_))
        unlocked([this] { carryTrace(work_); });
      else
        sleep(lock);
    }
  }
}

}  // namespace triscope
