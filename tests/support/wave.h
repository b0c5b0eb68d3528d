// A domain whose smallest edge and constraints take seconds to find: for tests that give up the search.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace triscope::support {

/// A closed wave of so many points, each of which looks across at the others.
inline std::string wave(int points) {
  std::string text;
  for (int k = 0; k < points; ++k) {
    const double turn = 2.0 * 3.14159265358979 * k / points;
    const double radius = 1.0 + 0.02 * std::sin(60.0 * turn);
    text += fmt::format("{}[{:.12f}, {:.12f}]", k == 0 ? "" : ", ", radius * std::cos(turn), radius * std::sin(turn));
  }
  return R"({"outer": [[-2, -2], [2, -2], [2, 2], [-2, 2]], "holes": [[)" + text + "]]}";
}

}  // namespace triscope::support
