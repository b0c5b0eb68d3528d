#include "core/base/file_identity.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <charconv>
#include <system_error>

namespace triscope {
namespace {

namespace fs = std::filesystem;

constexpr int kMostLinks = 40;  // as the kernel has it

/// What a symbolic link says; nothing of what is none.
std::optional<fs::path> linkedTo(const fs::path& at) {
  std::error_code failure;
  if (!fs::is_symlink(fs::symlink_status(at, failure))) return std::nullopt;
  const fs::path next = fs::read_symlink(at, failure);
  if (failure) return std::nullopt;
  return next.is_absolute() ? next : at.parent_path() / next;
}

fs::path folderOf(const fs::path& file) {
  const fs::path parent = file.parent_path();
  std::error_code failure;
  return fs::weakly_canonical(parent.empty() ? fs::path(".") : parent, failure);
}

std::optional<int> wholeNumber(const std::string& text) {
  int value = 0;
  const char* const last = text.data() + text.size();
  const auto [stop, failure] = std::from_chars(text.data(), last, value);
  if (failure != std::errc{} || stop != last || value < 0) return std::nullopt;
  return value;
}

Error overwritten(const NamedFile& output, const NamedFile& other, std::string_view role) {
  return {.kind = ErrorKind::usage,
          .message = fmt::format("{} {} {}{}", output.what, role, other.what,
                                 other.path == output.path ? std::string() : " (" + other.path + ")"),
          .hint = "name another file",
          .file = output.path,
          .loop = {}};
}

}  // namespace

fs::path targetOf(const std::string& path) {
  fs::path at = path;
  for (int links = 0; links < kMostLinks; ++links) {
    const std::optional<fs::path> next = linkedTo(at);
    if (!next) break;
    at = *next;
  }
  return at;
}

std::optional<int> descriptorNamed(const std::string& path) {
  std::error_code failure;
  const fs::path own = fs::canonical("/proc/self/fd", failure);
  std::optional<fs::path> at = failure ? std::nullopt : std::optional(fs::path(path));
  for (int links = 0; at && links < kMostLinks; ++links) {
    if (folderOf(*at) == own) return wholeNumber(at->filename().string());
    at = linkedTo(*at);
  }
  return std::nullopt;
}

bool sameFile(const std::string& a, const std::string& b) {
  struct stat first{}, second{};
  const bool firstIs = ::stat(a.c_str(), &first) == 0, secondIs = ::stat(b.c_str(), &second) == 0;
  if (firstIs != secondIs) return false;
  if (firstIs) return S_ISREG(first.st_mode) && first.st_dev == second.st_dev && first.st_ino == second.st_ino;
  const fs::path one = targetOf(a), other = targetOf(b);
  return one.filename() == other.filename() && folderOf(one) == folderOf(other);
}

Status checkOverwrites(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs) {
  for (auto output = outputs.begin(); output != outputs.end(); ++output) {
    if (output->path.empty()) continue;
    for (const NamedFile& input : inputs)
      if (!input.path.empty() && sameFile(output->path, input.path))
        return overwritten(*output, input, "would overwrite");
    const bool open = descriptorNamed(output->path).has_value();
    for (auto earlier = outputs.begin(); earlier != output; ++earlier)
      if (!earlier->path.empty() && !(open && descriptorNamed(earlier->path)) && sameFile(output->path, earlier->path))
        return overwritten(*output, *earlier, "would overwrite what is written by");
  }
  return success();
}

}  // namespace triscope
