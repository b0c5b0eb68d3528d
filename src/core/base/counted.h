// Counts as people read them: thousands set apart, and the noun in its right number.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace triscope {

/// "12 345" with a thin space; four digits stay together.
std::string grouped(std::uint64_t value);
/// "1 triangle", "1691 triangles", "12 345 triangles".
std::string counted(std::uint64_t count, std::string_view one, std::string_view many);

/// The same text with plain digits, for scripts and terminals: "12345 triangles".
std::string ungrouped(std::string text);

}  // namespace triscope
