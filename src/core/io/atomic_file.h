// A file that appears whole or not at all: written under another name beside its place, renamed when complete.
#pragma once

#include <string>
#include <string_view>

#include "core/result.h"

namespace triscope {

class AtomicFile {
 public:
  /// Opens a new temporary file in the folder of `path`. What is no regular file (a terminal, a pipe) is written
  /// to directly. Errors: cannot_write, saying why.
  static Result<AtomicFile> create(const std::string& path);
  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&& other) noexcept;
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  /// Removes the temporary file unless it was committed.
  ~AtomicFile();

  Status write(std::string_view text);
  /// Everything written has reached the file system: what can fail has failed or succeeded. Then only a rename is left.
  Status close();
  /// Puts the file in its place; closes it first where that has not been done.
  Status commit();

 private:
  AtomicFile(std::string path, std::string temporary, int descriptor);
  void discard();
  [[nodiscard]] Error failure(std::string_view what) const;

  std::string path_;
  std::string temporary_;  // empty: written directly, or done
  int descriptor_ = -1;
};

/// All of a file in one go. Errors: cannot_write, saying why; then what was there before is still there.
Status writeWhole(const std::string& path, std::string_view bytes);

}  // namespace triscope
