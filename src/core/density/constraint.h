// An edge length asked for at a point, and where the wish came from (paper, section 2, Figure 1 a).
#pragma once

#include <cstdint>

#include "core/base/point.h"
#include "core/words/event.h"

namespace triscope {

struct Constraint {
  Point at;
  double length = 0.0;          // wished edge length, >= Δx
  Rule source = Rule::none;     // user_request, curvature, corner, gap or short_edge
  std::uint32_t curve = kNoId;  // curve of the boundary it came from, or index of the user's request
};

}  // namespace triscope
