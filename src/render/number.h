// Numbers as people read them: three or four digits that matter, no trailing zeros, thousands set apart.
#pragma once

#include <cstdint>
#include <string>

namespace triscope {

/// "3.78", "0.001", "12.5", "1694", "2.3e-07": about `digits` significant digits.
std::string compact(double value, int digits = 3);
/// "12 345" with a thin space; four digits stay together.
std::string grouped(std::uint64_t value);

}  // namespace triscope
