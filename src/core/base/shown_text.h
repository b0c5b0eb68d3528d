// Text that others wrote, as messages show it: a name in a file must neither command the terminal nor fill it.
#pragma once

#include <string>
#include <string_view>

namespace triscope {

inline constexpr std::size_t kLongestShown = 80;  // bytes

/// A name, a key or a number as given: on one line, with "…" for what is beyond `longest` bytes, and with escapes such
/// as \n and \x1b for control characters and for what is not UTF-8.
std::string shown(std::string_view text, std::size_t longest = kLongestShown);

/// A whole message or answer, of any length, with the same escapes; its own ends of lines stay.
std::string shownLines(std::string_view text);

}  // namespace triscope
