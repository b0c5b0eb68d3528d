#include "core/base/stop.h"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstring>
#include <mutex>
#include <string_view>
#include <utility>

namespace triscope {
namespace {

struct EndingSignal {
  int number;
  std::string_view words;  // empty: nothing is said
};
constexpr std::array<EndingSignal, 4> kSignals{{
    {SIGINT, "stopped by Ctrl+C"},
    {SIGTERM, "stopped by TERM"},
    {SIGHUP, "stopped, the terminal is gone"},
    {SIGPIPE, ""},
}};

struct Temporary {
  bool used = false;
  std::array<char, PATH_MAX> path{};
};
// Changed under the mutex and an Undisturbed; read by end(), which runs when no Undisturbed is left.
std::array<Temporary, 64> temporaries;
std::mutex temporariesMutex;

// All that a handler reads. Sequentially consistent: of a thread that begins an Undisturbed and a handler that comes at
// the same time, at least one sees the other.
std::atomic<int> stopBy{0};       // the signal to end by
std::atomic<int> undisturbed{0};  // threads that must not be cut
std::atomic<bool> ending{false};
std::atomic<Written> written{Written::nothing};
std::atomic<bool> progressShown{false};
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<bool>::is_always_lock_free &&
                  std::atomic<Written>::is_always_lock_free,
              "a signal handler may touch nothing else");

thread_local int nesting = 0;  // of Undisturbed on this thread

// From here to onSignal() only what POSIX lets a handler call.

std::string_view outcome() {
  switch (written.load()) {
    case Written::nothing:
      return "; nothing was written\n";
    case Written::direct:
      return "; no file was changed\n";
    case Written::files:
      break;
  }
  return "; what was complete before is written\n";
}

/// One line, in one piece; nothing to a terminal or a pipe that takes nothing now.
void sayWhy() {
  std::array<char, 256> line{};
  std::size_t length = 0;
  const auto add = [&](std::string_view text) {
    std::memcpy(line.data() + length, text.data(), text.size());
    length += text.size();
  };
  for (const EndingSignal& signal : kSignals) {
    if (signal.number != stopBy || signal.words.empty()) continue;
    if (progressShown) add("\r\x1b[K");
    add("triscope: ");
    add(signal.words);
    add(outcome());
  }
  pollfd ready{.fd = STDERR_FILENO, .events = POLLOUT, .revents = 0};
  if (length == 0 || ::poll(&ready, 1, 0) != 1 || (ready.revents & POLLOUT) == 0) return;
  [[maybe_unused]] const ssize_t said = ::write(STDERR_FILENO, line.data(), length);
}

/// Runs once; returns where another thread is at it.
void end() {
  if (ending.exchange(true)) return;
  for (const Temporary& temporary : temporaries)
    if (temporary.used) ::unlink(temporary.path.data());
  sayWhy();
  ::_exit(128 + stopBy);
}

extern "C" void onSignal(int number) {
  const int error = errno;
  int none = 0;
  stopBy.compare_exchange_strong(none, number);
  if (undisturbed == 0) end();
  errno = error;
}

void leave() {
  if (--undisturbed == 0 && stopBy != 0) end();
}

}  // namespace

void endOnSignals() {
  struct sigaction action{};
  action.sa_handler = onSignal;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  for (const EndingSignal& signal : kSignals) sigaddset(&action.sa_mask, signal.number);
  for (const EndingSignal& signal : kSignals) {
    struct sigaction before{};
    // `nohup` has asked for it; a shell that ignores Ctrl+C for what it runs in the background has not.
    const bool kept = signal.number == SIGHUP && ::sigaction(SIGHUP, nullptr, &before) == 0 &&
                      before.sa_handler == SIG_IGN;  // NOLINT: a macro of the system
    if (!kept) ::sigaction(signal.number, &action, nullptr);
  }
  ::sigprocmask(SIG_UNBLOCK, &action.sa_mask, nullptr);
  // A file that grows past the limit set for it is an error like a full disk.
  std::signal(SIGXFSZ, SIG_IGN);
}

Undisturbed::Undisturbed() {
  if (nesting++ > 0) return;
  ++undisturbed;
  if (stopBy == 0) return;
  leave();
  for (;;) ::pause();  // the program is ending
}

Undisturbed::~Undisturbed() {
  if (--nesting == 0) leave();
}

void rememberTemporary(const std::string& path) {
  if (path.size() >= PATH_MAX) return;
  const std::lock_guard lock(temporariesMutex);
  for (Temporary& temporary : temporaries) {
    if (std::exchange(temporary.used, true)) continue;
    std::memcpy(temporary.path.data(), path.c_str(), path.size() + 1);
    return;
  }
}

void forgetTemporary(const std::string& path) {
  const std::lock_guard lock(temporariesMutex);
  for (Temporary& temporary : temporaries) {
    if (!temporary.used || path != temporary.path.data()) continue;
    temporary.used = false;
    return;
  }
}

void noteWritten(Written what) {
  for (Written before = written; before < what && !written.compare_exchange_weak(before, what);) {
  }
}

void noteProgressShown(bool shown) { progressShown = shown; }

}  // namespace triscope
