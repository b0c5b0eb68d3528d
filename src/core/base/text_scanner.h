// Reads words and numbers from a text and knows the line it is at. The first thing that went wrong is kept; from then
// on every read gives zero, so that a reader may ask once after a block instead of after every number.
#pragma once

#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/base/shown_text.h"

namespace triscope {

class TextScanner {
 public:
  /// `comment` starts a comment that runs to the end of its line; 0: there are none.
  explicit TextScanner(std::string_view text, char comment = 0, std::size_t firstLine = 1)
      : text_(text), comment_(comment), line_(firstLine) {}

  [[nodiscard]] std::size_t line() const { return line_; }
  [[nodiscard]] bool failed() const { return error_.has_value(); }
  [[nodiscard]] Error error() const { return error_.value_or(Error{}); }
  [[nodiscard]] std::string_view rest() const { return text_.substr(at_); }

  void fail(std::string message, std::string hint) {
    if (error_) return;
    error_ = Error{.kind = ErrorKind::bad_data,
                   .message = fmt::format("line {}: {}", line_, message),
                   .hint = std::move(hint),
                   .file = {},
                   .loop = {}};
    at_ = text_.size();
  }

  /// Next word, "" at the end.
  std::string_view word() {
    skipSpace();
    const std::size_t begin = at_;
    while (at_ < text_.size() && !isSpace(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
  }
  [[nodiscard]] bool atEnd() {
    skipSpace();
    return at_ >= text_.size();
  }
  /// The words that are left on this line.
  std::string_view restOfLine() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && text_[at_] != '\n') ++at_;
    return text_.substr(begin, at_ - begin);
  }
  /// True when no word is left on this line.
  [[nodiscard]] bool lineIsOver() {
    while (at_ < text_.size() && text_[at_] != '\n' && isSpace(text_[at_])) ++at_;
    return at_ >= text_.size() || text_[at_] == '\n' || (comment_ != 0 && text_[at_] == comment_);
  }

  double number(std::string_view what) {
    const std::string_view found = word();
    double value = 0.0;
    const auto [end, code] =
        std::from_chars(found.data() + (found.starts_with('+') ? 1 : 0), found.data() + found.size(), value);
    if (code != std::errc() || end != found.data() + found.size() || !std::isfinite(value)) {
      complain(what, found, "a number");
      return 0.0;
    }
    return value;
  }
  /// A whole number in [lowest, highest].
  long long integer(std::string_view what, long long lowest, long long highest) {
    const std::string_view found = word();
    long long value = 0;
    const auto [end, code] = std::from_chars(found.data(), found.data() + found.size(), value);
    if (code != std::errc() || end != found.data() + found.size()) {
      complain(what, found, "a whole number");
      return lowest;
    }
    if (value < lowest || value > highest) {
      fail(fmt::format("{} is {}, outside {} to {}", what, value, lowest, highest), "the file is damaged");
      return lowest;
    }
    return value;
  }
  /// How many records follow; each takes at least `bytes` of text, so a false claim reserves no memory.
  std::size_t count(std::string_view what, std::size_t bytes) {
    const long long value = integer(what, 0, kMost);
    if (static_cast<std::size_t>(value) > (text_.size() - at_) / bytes + 1) {
      fail(fmt::format("{} is {}, more than the rest of the file can hold", what, value), "the file is cut short");
      return 0;
    }
    return static_cast<std::size_t>(value);
  }
  void expect(std::string_view wanted) {
    const std::string_view found = word();
    if (found != wanted) complain(wanted, found, fmt::format("'{}'", wanted));
  }

  static constexpr long long kMost = 400'000'000;  // records: indices and half-edges stay within 32 bits

 private:
  static bool isSpace(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }
  void skipSpace() {
    while (at_ < text_.size()) {
      if (comment_ != 0 && text_[at_] == comment_) {
        while (at_ < text_.size() && text_[at_] != '\n') ++at_;
      } else if (isSpace(text_[at_])) {
        line_ += text_[at_++] == '\n' ? 1u : 0u;
      } else {
        return;
      }
    }
  }
  void complain(std::string_view what, std::string_view found, std::string_view wanted) {
    if (found.empty()) {
      fail(fmt::format("the file ends where {} was expected", what), "the file is cut short");
    } else {
      fail(fmt::format("expected {} for {}, found '{}'", wanted, what, shown(found, 40)),
           "correct the file or write it anew");
    }
  }

  std::string_view text_;
  char comment_;
  std::size_t at_ = 0;
  std::size_t line_;
  std::optional<Error> error_;
};

}  // namespace triscope
