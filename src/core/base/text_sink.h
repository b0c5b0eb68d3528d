// Where writers put their text: collected in memory, handed on in blocks, so that a large mesh needs no large buffer.
#pragma once

#include <optional>

#include "core/base/append_text.h"
#include "core/base/atomic_file.h"
#include "core/base/result.h"

namespace triscope {

class TextSink {
 public:
  explicit TextSink(AtomicFile& file) : file_(file) {}

  /// `format` is FMT_COMPILE("…").
  template <class Format, class... Args>
  void print(const Format& format, const Args&... args) {
    triscope::print(buffer_, format, args...);
    if (buffer_.size() >= kBlock) flush();
  }
  /// Hands on what has been collected. The first thing that went wrong, if anything did.
  Status finish() {
    flush();
    return failure_ ? Status(*failure_) : success();
  }

 private:
  static constexpr std::size_t kBlock = 1u << 16;

  void flush() {
    if (!failure_) {
      if (Status written = file_.write({buffer_.data(), buffer_.size()}); !written) failure_ = written.error();
    }
    buffer_.clear();
  }

  AtomicFile& file_;
  TextBuffer buffer_;
  std::optional<Error> failure_;
};

}  // namespace triscope
