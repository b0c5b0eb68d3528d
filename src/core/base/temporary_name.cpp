#include "core/base/temporary_name.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string_view>
#include <system_error>

#include "core/base/file_identity.h"

namespace triscope {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestStem = 200;  // bytes of the name: with the rest it stays below the 255 of most systems
constexpr std::string_view kExtension = ".tmp";

std::string prefixOf(const fs::path& target) {
  return fmt::format(".{}.", target.filename().string().substr(0, kLongestStem));
}

/// "PID-N" between prefix and extension.
bool isTemporary(std::string_view name, std::string_view prefix) {
  if (!name.starts_with(prefix) || !name.ends_with(kExtension)) return false;
  if (name.size() < prefix.size() + kExtension.size()) return false;
  name = name.substr(prefix.size(), name.size() - prefix.size() - kExtension.size());
  const auto isNumber = [](std::string_view text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
  };
  const std::size_t dash = name.find('-');
  return dash != std::string_view::npos && isNumber(name.substr(0, dash)) && isNumber(name.substr(dash + 1));
}

/// Removes the file if it is regular and its lock is free.
void removeIfStale(const fs::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return;
  struct stat info{};
  // Removed while locked: a program that has just made it, and comes to lock it now, takes another name.
  if (::fstat(descriptor, &info) == 0 && S_ISREG(info.st_mode) && ::flock(descriptor, LOCK_SH | LOCK_NB) == 0)
    ::unlink(file.c_str());
  ::close(descriptor);
}

}  // namespace

fs::path temporaryName(const fs::path& target, int n) {
  return target.parent_path() / fmt::format("{}{}-{}{}", prefixOf(target), ::getpid(), n, kExtension);
}

bool lockTemporary(int descriptor) {
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) return errno != EWOULDBLOCK;
  struct stat info{};
  return ::fstat(descriptor, &info) != 0 || info.st_nlink > 0;  // cleared between its making and the lock
}

void keepFromClearing(const std::string& path) {
  const std::string name = targetOf(path).filename().string();
  if (!name.starts_with('.') || !name.ends_with(kExtension)) return;
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);  // stays open, and so locked
  if (descriptor >= 0) (void)lockTemporary(descriptor);
}

void clearStale(const fs::path& target) {
  const std::string prefix = prefixOf(target);
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  std::error_code failure;
  for (fs::directory_iterator at(folder, failure), end; !failure && at != end; at.increment(failure))
    if (isTemporary(at->path().filename().string(), prefix)) removeIfStale(at->path());
}

}  // namespace triscope
