// Names of temporary files, and which of them nobody uses any more.
#pragma once

#include <filesystem>
#include <string>

namespace triscope {

/// ".NAME.PID-N.tmp" beside `target`.
std::filesystem::path temporaryName(const std::filesystem::path& target, int n);

/// Locks an open file as long as it is open; false when another program has it. A file system that knows no locks
/// says true.
bool lockTemporary(int descriptor);

/// Keeps an input that may be called like a temporary file from being cleared as one, until this program ends.
void keepFromClearing(const std::string& path);

/// Removes temporary files for `target` that no running program has locked.
void clearStale(const std::filesystem::path& target);

}  // namespace triscope
