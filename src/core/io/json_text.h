// JSON's two awkward values as text: strings and numbers.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <string_view>

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
inline std::string jsonNumber(double value) {
  if (!std::isfinite(value)) return "null";
  if (value == 0.0 && std::signbit(value)) return "-0.0";  // "-0" is read as a whole number, which has no such zero
  return fmt::format("{}", value);
}

}  // namespace triscope
