// Ctrl+C asks a run to stop between two decisions, so that no file is left half written.
#pragma once

namespace triscope {

/// From now on SIGINT and SIGTERM only raise the flag that interrupted() reads.
void watchForInterrupt();
bool interrupted();

}  // namespace triscope
