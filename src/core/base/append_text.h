// Text at the end of a buffer, from formats that are read when the program is built. Numbers get the fewest digits that
// read back the same; they are most of what a large file is made of, and of the time it takes.
#pragma once

#include <fmt/compile.h>
#include <fmt/format.h>

#include <iterator>
#include <string_view>
#include <type_traits>

namespace triscope {

using TextBuffer = fmt::memory_buffer;

inline void appendText(TextBuffer& out, std::string_view text) { out.append(text.data(), text.data() + text.size()); }

/// Bytes to have free for a number: no more are written.
inline constexpr std::size_t kLongestNumber = 32;

/// `format` is FMT_COMPILE("…").
template <class Format, class... Args>
void print(TextBuffer& out, const Format& format, const Args&... args) {
  if constexpr ((std::is_arithmetic_v<Args> && ...)) {
    const std::size_t before = out.size();
    out.reserve(before + fmt::string_view(format).size() + sizeof...(Args) * kLongestNumber);
    const char* const end = fmt::format_to(out.data() + before, format, args...);
    out.resize(static_cast<std::size_t>(end - out.data()));
  } else {
    fmt::format_to(std::back_inserter(out), format, args...);
  }
}

}  // namespace triscope
