// The five insertion rules of the paper (section 3.1), side by side.
#pragma once

#include "core/state.h"

namespace triscope {

/// What the rules look at in a triangle. Lengths are squared where the name says so.
struct Shape {
  Point a, b, c;
  Point centre;                // circumcentre
  double squaredRadius = 0;    // R²
  double squaredShortest = 0;  // e²
};
Shape shapeOf(const Mesh& mesh, std::int32_t slot);

struct Proposal {
  Point at;
  double measured = 0.0;    // R, or |p5 p4| in step 5
  double limit = 0.0;       // what it is not below
  double nearest = 0.0;     // the new point must be at least this far from every vertex
  std::int32_t other = -1;  // slot of the adjacent triangle that the limit came from, -1 when none
};

/// True when the rule of `step` (step1 … step5) proposes a point for the triangle.
bool proposes(Stage step, const MeshState& state, std::int32_t slot, Proposal& proposal);

}  // namespace triscope
