#include "core/quality/bound_figure.h"

#include <fmt/format.h>

#include <cmath>

namespace triscope {

std::string besideBound(double value, double bound, int decimals) {
  constexpr int kMostDecimals = 9;
  double unit = 1.0;
  for (int k = 0; k < decimals; ++k) unit *= 0.1;
  while (value != bound && decimals < kMostDecimals && std::fabs(value - bound) <= 0.5 * unit) {
    ++decimals;
    unit *= 0.1;
  }
  return fmt::format("{:.{}f}", value, decimals);
}

}  // namespace triscope
