// What this process has cost so far.
#pragma once

#include <cstdint>

namespace triscope::bench {

/// Seconds of processor time: unlike those on the wall, they do not count what other work takes.
double processorSeconds();
/// The most memory that it has had at once.
std::int64_t peakBytes();

}  // namespace triscope::bench
