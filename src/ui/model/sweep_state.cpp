#include "ui/model/sweep_state.h"

#include <algorithm>
#include <cmath>

namespace triscope {

std::vector<double> sweptValues(SweepRange range) {
  if (range.from == range.to) range.count = 1;
  return valuesOf(range);
}

std::size_t nearestCell(const SweepTable& table, const Settings& settings) {
  const auto nearest = [](const std::vector<double>& values, double to) {
    const auto closer = [to](double a, double b) { return std::fabs(a - to) < std::fabs(b - to); };
    return static_cast<std::size_t>(std::min_element(values.begin(), values.end(), closer) - values.begin());
  };
  return nearest(table.omegas, settings.omega) * table.thetas.size() + nearest(table.thetas, settings.theta);
}

}  // namespace triscope
