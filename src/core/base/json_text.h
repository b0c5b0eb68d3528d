// JSON's two awkward values as text: strings and numbers.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <string_view>

#include "core/base/append_text.h"

namespace triscope {

/// Between quotes, with what must be escaped.
inline std::string jsonText(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      out += fmt::format("\\u{:04x}", static_cast<unsigned>(static_cast<unsigned char>(c)));
    } else {
      out += c;
    }
  }
  return out + '"';
}

/// Shortest text that reads back as the same double; null for what JSON has no number for.
inline void appendJsonNumber(TextBuffer& out, double value) {
  if (!std::isfinite(value)) return appendText(out, "null");
  if (value == 0.0 && std::signbit(value)) return appendText(out, "-0.0");  // "-0" would be a whole number
  print(out, FMT_COMPILE("{}"), value);
}

inline std::string jsonNumber(double value) {
  TextBuffer out;
  appendJsonNumber(out, value);
  return {out.data(), out.size()};
}

}  // namespace triscope
