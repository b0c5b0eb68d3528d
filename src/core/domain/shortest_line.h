// The shortest straight curve of a domain: its ends are kept, so that no mesh of the domain can do without an edge as
// short as it or shorter.
#pragma once

#include <cstdint>
#include <limits>

#include "core/domain/domain.h"

namespace triscope {

struct ShortestLine {
  double length = std::numeric_limits<double>::infinity();  // infinite when no curve is straight
  std::uint32_t curve = 0;                                  // the first of equals, in Domain::curves
};
ShortestLine shortestLine(const Domain& domain);

}  // namespace triscope
