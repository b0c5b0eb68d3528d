// Numbers as people read them: three or four digits that matter, no trailing zeros.
#pragma once

#include <string>

#include "core/base/counted.h"  // counts belong to it

namespace triscope {

/// "3.78", "0.001", "12.5", "1694", "2.3e-07": about `digits` significant digits.
std::string compact(double value, int digits = 3);

/// Up to the next number of two significant digits, which can be typed. `value` above 0.
double roundedUp(double value);

}  // namespace triscope
