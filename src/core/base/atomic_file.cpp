#include "core/base/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>
#include <utility>

#include "core/base/assert.h"
#include "core/base/file_identity.h"
#include "core/base/stop.h"
#include "core/base/temporary_name.h"

namespace triscope {
namespace {

namespace fs = std::filesystem;

constexpr int kAttempts = 1000;               // names to try
constexpr mode_t kAnyWrite = 0222;            // somebody may write
constexpr off_t kWriteBack = off_t{8} << 20;  // bytes: then the disk begins, so that the flush at the end is short

Error cannotWrite(const std::string& path, std::string_view what, int error) {
  const char* hint = "check the folder and its permissions";
  if (error == ENOENT || error == ENOTDIR) hint = "the folder does not exist: make it, or choose another";
  if (error == EACCES || error == EPERM || error == EROFS) hint = "choose a folder that you may write to";
  if (error == ENOSPC || error == EDQUOT) hint = "make room, or choose another disk";
  if (error == EFBIG) hint = "a limit is set for the size of files ('ulimit -f')";
  return {.kind = ErrorKind::cannot_write,
          .message = fmt::format("{}: {}", what, std::strerror(error)),
          .hint = hint,
          .file = path,
          .loop = {}};
}

/// A file that was made safe from being written to is not replaced either, which a folder alone would allow.
bool isProtected(const std::string& path, mode_t mode) {
  return (mode & kAnyWrite) == 0 || ::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0;
}

}  // namespace

AtomicFile::AtomicFile(std::string path, std::string temporary, int descriptor, Flush flush)
    : path_(std::move(path)),
      temporary_(std::move(temporary)),
      descriptor_(descriptor),
      flush_(flush),
      direct_(temporary_.empty()) {}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : path_(std::move(other.path_)),
      temporary_(std::exchange(other.temporary_, {})),
      old_(std::exchange(other.old_, {})),
      held_(std::move(other.held_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      oldDescriptor_(std::exchange(other.oldDescriptor_, -1)),
      size_(other.size_),
      started_(other.started_),
      flush_(other.flush_),
      direct_(other.direct_),
      holds_(other.holds_),
      fresh_(other.fresh_) {}

AtomicFile& AtomicFile::operator=(AtomicFile&& other) noexcept {
  if (this != &other) {
    discard();
    path_ = std::move(other.path_);
    temporary_ = std::exchange(other.temporary_, {});
    old_ = std::exchange(other.old_, {});
    held_ = std::move(other.held_);
    descriptor_ = std::exchange(other.descriptor_, -1);
    oldDescriptor_ = std::exchange(other.oldDescriptor_, -1);
    size_ = other.size_;
    started_ = other.started_;
    flush_ = other.flush_;
    direct_ = other.direct_;
    holds_ = other.holds_;
    fresh_ = other.fresh_;
  }
  return *this;
}

AtomicFile::~AtomicFile() { discard(); }

void AtomicFile::discard() {
  if (!temporary_.empty() || !old_.empty()) {
    const Undisturbed whole;
    for (std::string* name : {&temporary_, &old_}) {
      if (name->empty()) continue;
      ::unlink(name->c_str());
      forgetTemporary(*name);
      name->clear();
    }
  }
  for (int* descriptor : {&descriptor_, &oldDescriptor_})
    if (*descriptor >= 0) ::close(std::exchange(*descriptor, -1));
}

Error AtomicFile::failure(std::string_view what) const { return cannotWrite(path_, what, errno); }

Result<AtomicFile> AtomicFile::create(const std::string& path, Flush flush) {
  if (path.empty()) {
    return Error{.kind = ErrorKind::cannot_write,
                 .message = "no file name given",
                 .hint = "name a file",
                 .file = {},
                 .loop = {}};
  }
  if (const std::optional<int> descriptor = descriptorNamed(path)) return onDescriptor(path, *descriptor, flush);
  struct stat info{};
  const bool exists = ::stat(path.c_str(), &info) == 0;  // of what a link points at
  if (exists && S_ISDIR(info.st_mode)) return cannotWrite(path, "cannot write", EISDIR);
  if (exists && !S_ISREG(info.st_mode)) {
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor < 0) return cannotWrite(path, "cannot open for writing", errno);
    return AtomicFile(path, {}, descriptor, flush);
  }
  if (exists && isProtected(path, info.st_mode)) {
    return Error{.kind = ErrorKind::cannot_write,
                 .message = "the file is protected from being written to",
                 .hint = "choose another name, or allow it ('chmod u+w')",
                 .file = path,
                 .loop = {}};
  }
  const fs::path target = targetOf(path);  // a link stays a link: what it points at is replaced
  clearStale(target);
  // Until it is complete, nobody else may read what the file that it replaces may have kept from them.
  const mode_t mode = exists ? 0600 : 0666;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const std::string temporary = temporaryName(target, attempt).string();
    const Undisturbed whole;
    const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    if (descriptor < 0 && errno == EEXIST) continue;
    if (descriptor < 0) break;
    if (!lockTemporary(descriptor)) {  // another program is about to clear it
      ::close(descriptor);
      continue;
    }
    rememberTemporary(temporary);
    return AtomicFile(target.string(), temporary, descriptor, flush);
  }
  return cannotWrite(path, "cannot create a file", errno);
}

Result<AtomicFile> AtomicFile::onDescriptor(const std::string& path, int descriptor, Flush flush) {
  const int flags = ::fcntl(descriptor, F_GETFL);
  if (flags >= 0 && (flags & O_ACCMODE) == O_RDONLY) return cannotWrite(path, "cannot write", EBADF);
  // Not opened anew by its name: that would write to the beginning of the file.
  const int copy = ::fcntl(descriptor, F_DUPFD_CLOEXEC, 0);
  if (copy < 0) return cannotWrite(path, "cannot open for writing", errno);
  AtomicFile file(path, {}, copy, flush);
  struct stat info{};
  file.holds_ = ::fstat(copy, &info) == 0 && S_ISREG(info.st_mode);
  return file;
}

Status AtomicFile::write(std::string_view text) {
  TRISCOPE_CHECK(descriptor_ >= 0, "nothing is written to a file that is complete");
  if (holds_) {
    held_ += text;
    return success();
  }
  if (direct_ && !text.empty()) noteWritten(Written::direct);
  return put(text);
}

Status AtomicFile::put(std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor_, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return failure("cannot write");
    text.remove_prefix(static_cast<std::size_t>(written));
    size_ += written;
  }
  if (!direct_ && flush_ == Flush::yes && size_ - started_ >= kWriteBack) {
    ::sync_file_range(descriptor_, started_, size_ - started_, SYNC_FILE_RANGE_WRITE);  // no harm where it fails
    started_ = size_;
  }
  return success();
}

Status AtomicFile::complete() {
  if (direct_) return holds_ ? success() : close();
  struct stat old{};
  if (::lstat(path_.c_str(), &old) == 0 && S_ISREG(old.st_mode)) {
    const bool owned = ::fchown(descriptor_, old.st_uid, old.st_gid) == 0;
    if (!owned) [[maybe_unused]]
      const int group = ::fchown(descriptor_, static_cast<uid_t>(-1), old.st_gid);
    // What runs with the rights of its owner must not come to run with another's.
    ::fchmod(descriptor_, old.st_mode & (owned ? 07777 : 0777));
  }
  if (flush_ == Flush::yes && ::fsync(descriptor_) != 0 && errno != EINVAL && errno != EROFS)
    return failure("cannot finish writing");
  return success();
}

Status AtomicFile::close() {
  return ::close(std::exchange(descriptor_, -1)) == 0 ? success() : failure("cannot finish writing");
}

Status AtomicFile::deliver() {
  if (!holds_) return success();
  if (!held_.empty()) noteWritten(Written::files);
  if (Status written = put(held_); !written) return written;
  return close();
}

void AtomicFile::keepOld() {
  if (direct_) return;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const std::string name = temporaryName(path_, attempt).string();
    if (::link(path_.c_str(), name.c_str()) != 0) {
      if (errno == EEXIST) continue;
      fresh_ = errno == ENOENT;
      return;
    }
    old_ = name;
    oldDescriptor_ = ::open(name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (oldDescriptor_ >= 0) (void)lockTemporary(oldDescriptor_);
    rememberTemporary(name);
    return;
  }
}

Status AtomicFile::place() {
  if (direct_) return success();
  if (std::rename(temporary_.c_str(), path_.c_str()) != 0) return failure("cannot put the finished file in its place");
  forgetTemporary(temporary_);
  temporary_.clear();
  return success();
}

void AtomicFile::putBack() {
  if (direct_ || !temporary_.empty()) return;
  if (fresh_) ::unlink(path_.c_str());
  if (old_.empty() || std::rename(old_.c_str(), path_.c_str()) != 0) return;
  forgetTemporary(old_);
  old_.clear();
}

}  // namespace triscope
