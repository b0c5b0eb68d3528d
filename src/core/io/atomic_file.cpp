#include "core/io/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

namespace triscope {
namespace {

namespace fs = std::filesystem;

Error cannotWrite(const std::string& path, std::string_view what, int error) {
  const char* hint = "check the folder and its permissions";
  if (error == ENOENT || error == ENOTDIR) hint = "the folder does not exist: make it, or choose another";
  if (error == EACCES || error == EPERM || error == EROFS) hint = "choose a folder that you may write to";
  if (error == ENOSPC || error == EDQUOT) hint = "make room, or choose another disk";
  return {.code = ExitCode::cannot_write,
          .message = fmt::format("{}: {}", what, std::strerror(error)),
          .hint = hint,
          .file = path,
          .loop = {}};
}

}  // namespace

AtomicFile::AtomicFile(std::string path, std::string temporary, int descriptor)
    : path_(std::move(path)), temporary_(std::move(temporary)), descriptor_(descriptor) {}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : path_(std::move(other.path_)),
      temporary_(std::exchange(other.temporary_, {})),
      descriptor_(std::exchange(other.descriptor_, -1)) {}

AtomicFile& AtomicFile::operator=(AtomicFile&& other) noexcept {
  if (this != &other) {
    discard();
    path_ = std::move(other.path_);
    temporary_ = std::exchange(other.temporary_, {});
    descriptor_ = std::exchange(other.descriptor_, -1);
  }
  return *this;
}

AtomicFile::~AtomicFile() { discard(); }

void AtomicFile::discard() {
  if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
  if (!temporary_.empty()) ::unlink(std::exchange(temporary_, {}).c_str());
}

Error AtomicFile::failure(std::string_view what) const { return cannotWrite(path_, what, errno); }

Result<AtomicFile> AtomicFile::create(const std::string& path) {
  if (path.empty()) {
    return Error{
        .code = ExitCode::cannot_write, .message = "no file name given", .hint = "name a file", .file = {}, .loop = {}};
  }
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);  // of what a link points at
  if (fs::is_directory(status)) return cannotWrite(path, "cannot write", EISDIR);
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor < 0) return cannotWrite(path, "cannot open for writing", errno);
    return AtomicFile(path, {}, descriptor);
  }
  // A link stays a link: what it points at is replaced.
  const fs::path target = fs::is_symlink(path, ignored) ? fs::weakly_canonical(path, ignored) : fs::path(path);
  for (int attempt = 0; attempt < 1000; ++attempt) {
    const fs::path temporary =
        target.parent_path() / fmt::format(".{}.{}-{}.tmp", target.filename().string(), ::getpid(), attempt);
    const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor >= 0) return AtomicFile(target.string(), temporary.string(), descriptor);
    if (errno != EEXIST) break;
  }
  return cannotWrite(path, "cannot create a file", errno);
}

Status AtomicFile::write(std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor_, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return failure("cannot write");
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return success();
}

Status AtomicFile::close() {
  if (descriptor_ >= 0 && ::close(std::exchange(descriptor_, -1)) != 0) return failure("cannot finish writing");
  return success();
}

Status AtomicFile::commit() {
  if (Status closed = close(); !closed) return closed;
  if (temporary_.empty()) return success();
  if (std::rename(temporary_.c_str(), path_.c_str()) != 0) return failure("cannot put the finished file in its place");
  temporary_.clear();
  return success();
}

Status writeWhole(const std::string& path, std::string_view bytes) {
  Result<AtomicFile> file = AtomicFile::create(path);
  if (!file) return file.error();
  if (const Status written = file->write(bytes); !written) return written;
  return file->commit();
}

}  // namespace triscope
