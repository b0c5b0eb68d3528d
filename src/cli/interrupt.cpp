#include "cli/interrupt.h"

#include <csignal>

namespace triscope {
namespace {

volatile std::sig_atomic_t raised = 0;

extern "C" void raiseFlag(int) { raised = 1; }

}  // namespace

void watchForInterrupt() {
  std::signal(SIGINT, raiseFlag);
  std::signal(SIGTERM, raiseFlag);
}

bool interrupted() { return raised != 0; }

}  // namespace triscope
