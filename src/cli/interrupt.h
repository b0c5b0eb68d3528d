// Ctrl+C asks a run to stop between two decisions, so that no file is left half written.
#pragma once

#include <atomic>

namespace triscope {

/// From now on SIGINT and SIGTERM only raise the flag that interrupted() reads.
void watchForInterrupt();
bool interrupted();
/// The flag itself, for what looks at one in the middle of its work, on any thread.
const std::atomic<bool>& interruptFlag();

}  // namespace triscope
