// How well the edges of a mesh go with the lengths that were wanted.
#pragma once

#include "core/method/state.h"

namespace triscope {

/// Of the edges that are no boundary, nor lie in triangles at the corners of the box around everything: e/h, an edge's
/// length over the length h wanted in its middle.
struct SizeFit {
  double mean = 0.0;    // 0 where there is no such edge
  double within = 0.0;  // part of them with e/h in [1/√2, √2]
};

/// O(triangles). The tree is that of the run; without one the fit is 0.
SizeFit sizeFitOf(const MeshState& state);

}  // namespace triscope
