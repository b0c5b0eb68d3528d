// Files that appear together or not at all: all are written beside their places, and renamed when the last is complete.
#pragma once

#include <list>
#include <string>
#include <string_view>

#include "core/base/atomic_file.h"
#include "core/base/result.h"

namespace triscope {

class OutputSet {
 public:
  explicit OutputSet(Flush flush = Flush::yes) : flush_(flush) {}

  /// The file of this name, opened if it is not yet open: early, what cannot be written is found before a long run.
  /// The pointer holds as long as the set. Errors: cannot_write, saying why.
  Result<AtomicFile*> open(const std::string& path);
  /// All of one file.
  Status write(const std::string& path, std::string_view bytes);
  /// It is not to appear after all.
  void leaveOut(const std::string& path);
  /// Everything is on the disk, and all files take their places. On an error, as without commit(), every place holds
  /// what it held before. A program that is killed outright (signal 9, a power cut) between two renames, which takes
  /// microseconds, may leave some of them new; one that is told to end comes before or after all of them.
  Status commit();

 private:
  struct Output {
    std::string path;  // as asked for
    AtomicFile file;
  };
  std::list<Output> outputs_;
  Flush flush_;
};

/// A set of one file. Errors: cannot_write, saying why; then what was there before is still there.
Status writeWhole(const std::string& path, std::string_view bytes, Flush flush = Flush::yes);

}  // namespace triscope
