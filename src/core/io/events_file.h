// Events as JSON lines: one object a line, names instead of numbers. Written as they come, so that a run of any
// length needs no memory for them.
#pragma once

#include <span>
#include <string>

#include "core/base/append_text.h"
#include "core/base/output_set.h"
#include "core/base/result.h"
#include "core/words/event.h"

namespace triscope {

/// One event without the line end. `number` counts from 0. Absent members are left out; what a number means is said
/// by its key, which depends on the kind of event ("triangle", "cell", "vertex", …).
std::string eventLine(const Event& event, std::uint64_t number);

class EventsFile {
 public:
  /// One file of the set, which must outlive this. Its first line says which version of program and method wrote it.
  static Result<EventsFile> create(const std::string& path, OutputSet& set);
  Status append(std::span<const Event> events);
  /// Everything appended has been written. It takes its place with the set.
  Status finish();
  [[nodiscard]] std::uint64_t count() const { return count_; }

 private:
  explicit EventsFile(AtomicFile& file);

  AtomicFile* file_;
  std::uint64_t count_ = 0;
  TextBuffer buffer_;
};

}  // namespace triscope
