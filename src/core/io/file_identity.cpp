#include "core/io/file_identity.h"

#include <system_error>

namespace triscope {
namespace {

namespace fs = std::filesystem;

constexpr int kMostLinks = 40;  // as the kernel has it

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

}  // namespace triscope
