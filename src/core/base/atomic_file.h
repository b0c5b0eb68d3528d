// A file that appears whole or not at all: written under another name beside its place, renamed when complete. What
// writes files uses it through an OutputSet.
#pragma once

#include <sys/types.h>

#include <string>
#include <string_view>

#include "core/base/result.h"

namespace triscope {

/// Whether a file must be on the disk before it replaces another: not so for what a running program keeps rewriting.
enum class Flush : bool { no, yes };

class AtomicFile {
 public:
  /// Opens a temporary file in the folder of `path`, and clears those that programs which are gone left there for the
  /// same name. What is no regular file (a terminal, a pipe) is written to directly; a pipe is waited for until
  /// somebody reads it. So is an open descriptor (/dev/stdout), whatever it leads to, from where it stands: what has
  /// been written there by others stays. Errors: cannot_write, saying why; a file that nobody may write to is one.
  static Result<AtomicFile> create(const std::string& path, Flush flush = Flush::yes);
  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&& other) noexcept;
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  /// Removes the temporary file.
  ~AtomicFile();

  Status write(std::string_view text);
  /// Everything written is on the disk, with the mode and, where that is allowed, the owner of the file that it is to
  /// replace: what can fail has failed or succeeded. Then only renames are left.
  Status complete();

  // The steps of OutputSet::commit(), under one Undisturbed.
  /// Writes to an open descriptor that leads to a regular file all that is for it.
  Status deliver();
  /// Keeps what is in the place under another name; a file system that has no links keeps nothing.
  void keepOld();
  Status place();
  /// As it was before place().
  void putBack();

  [[nodiscard]] const std::string& path() const { return path_; }  // links followed
  [[nodiscard]] bool direct() const { return direct_; }

 private:
  AtomicFile(std::string path, std::string temporary, int descriptor, Flush flush);
  static Result<AtomicFile> onDescriptor(const std::string& path, int descriptor, Flush flush);
  Status put(std::string_view text);
  Status close();
  void discard();
  [[nodiscard]] Error failure(std::string_view what) const;

  std::string path_;
  std::string temporary_;  // empty: written directly, or in its place
  std::string old_;        // what keepOld() kept; empty: nothing
  std::string held_;       // what deliver() will write
  int descriptor_ = -1;    // open as long as the temporary file is there: its lock says that it is in use
  int oldDescriptor_ = -1;
  off_t size_ = 0;
  off_t started_ = 0;  // up to here the system has been told to write to the disk
  Flush flush_ = Flush::yes;
  bool direct_ = false;
  bool holds_ = false;  // until deliver(): what is written into a file of others cannot be taken back
  bool fresh_ = false;  // keepOld() found nothing in the place
};

}  // namespace triscope
