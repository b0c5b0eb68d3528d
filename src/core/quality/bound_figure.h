// A figure beside the bound it is held to.
#pragma once

#include <string>

namespace triscope {

/// The value with this many decimals, or as many more (up to 9) as keep it from reading like a bound that it is not on:
/// "1.9996" beside 2, where "2.00 < 2" would contradict itself.
std::string besideBound(double value, double bound, int decimals);

}  // namespace triscope
