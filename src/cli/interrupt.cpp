#include "cli/interrupt.h"

#include <csignal>

namespace triscope {
namespace {

std::atomic<bool> raised{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may touch nothing else");

extern "C" void raiseFlag(int) { raised = true; }

}  // namespace

void watchForInterrupt() {
  std::signal(SIGINT, raiseFlag);
  std::signal(SIGTERM, raiseFlag);
}

bool interrupted() { return raised; }

const std::atomic<bool>& interruptFlag() { return raised; }

}  // namespace triscope
