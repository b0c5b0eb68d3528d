#include "core/base/shown_text.h"

#include <fmt/format.h>

#include <iterator>

namespace triscope {
namespace {

unsigned byteAt(std::string_view text, std::size_t at) { return static_cast<unsigned char>(text[at]); }

bool isContinuation(unsigned byte) { return (byte & 0xc0u) == 0x80u; }

/// Bytes of the character that begins here; 0 when it is not to be shown as it is.
std::size_t shownAsIs(std::string_view text, std::size_t at) {
  const unsigned first = byteAt(text, at);
  if (first < 0x80) return first >= 0x20 && first != 0x7f ? 1 : 0;
  if (first < 0xc2 || first > 0xf4) return 0;
  const std::size_t length = first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
  if (at + length > text.size()) return 0;
  for (std::size_t k = 1; k < length; ++k)
    if (!isContinuation(byteAt(text, at + k))) return 0;
  const bool control = first == 0xc2 && byteAt(text, at + 1) < 0xa0;  // the second block of control characters
  return control ? 0 : length;
}

std::string escaped(std::string_view text, bool keepLines) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    const std::size_t length = c == '\n' && keepLines ? 1 : shownAsIs(text, at);
    if (length > 0)
      out += text.substr(at, length);
    else if (c == '\n')
      out += "\\n";
    else
      fmt::format_to(std::back_inserter(out), "\\x{:02x}", byteAt(text, at));
    at += length > 0 ? length : 1;
  }
  return out;
}

}  // namespace

std::string shown(std::string_view text, std::size_t longest) {
  if (text.size() <= longest) return escaped(text, false);
  std::size_t end = longest;
  while (end > 0 && isContinuation(byteAt(text, end))) --end;
  return escaped(text.substr(0, end), false) + "…";
}

std::string shownLines(std::string_view text) { return escaped(text, true); }

}  // namespace triscope
