#include "core/base/file_identity.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <system_error>

namespace triscope {
namespace {

namespace fs = std::filesystem;

constexpr int kMostLinks = 40;  // as the kernel has it

Error overwritten(const NamedFile& output, const NamedFile& other, std::string_view role) {
  return {.code = ExitCode::usage,
          .message = fmt::format("{} {} {}{}", output.what, role, other.what,
                                 other.path == output.path ? std::string() : " (" + other.path + ")"),
          .hint = "name another file",
          .file = output.path,
          .loop = {}};
}

}  // namespace

fs::path targetOf(const std::string& path) {
  fs::path at = path;
  std::error_code failure;
  for (int links = 0; links < kMostLinks && fs::is_symlink(fs::symlink_status(at, failure)); ++links) {
    const fs::path next = fs::read_symlink(at, failure);
    if (failure) break;
    at = next.is_absolute() ? next : at.parent_path() / next;
  }
  return at;
}

bool sameFile(const std::string& a, const std::string& b) {
  struct stat first{}, second{};
  const bool firstIs = ::stat(a.c_str(), &first) == 0, secondIs = ::stat(b.c_str(), &second) == 0;
  if (firstIs != secondIs) return false;
  if (firstIs) return S_ISREG(first.st_mode) && first.st_dev == second.st_dev && first.st_ino == second.st_ino;
  const fs::path one = targetOf(a), other = targetOf(b);
  if (one.filename() != other.filename()) return false;
  std::error_code failure;
  const auto folder = [&](const fs::path& file) {
    const fs::path parent = file.parent_path();
    return fs::weakly_canonical(parent.empty() ? fs::path(".") : parent, failure);
  };
  return folder(one) == folder(other);
}

Status checkOverwrites(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs) {
  for (auto output = outputs.begin(); output != outputs.end(); ++output) {
    if (output->path.empty()) continue;
    for (const NamedFile& input : inputs)
      if (!input.path.empty() && sameFile(output->path, input.path))
        return overwritten(*output, input, "would overwrite");
    for (auto earlier = outputs.begin(); earlier != output; ++earlier)
      if (!earlier->path.empty() && sameFile(output->path, earlier->path))
        return overwritten(*output, *earlier, "would overwrite what is written by");
  }
  return success();
}

}  // namespace triscope
