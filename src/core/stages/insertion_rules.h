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

/// True when the rule of `step` (step1 … step5) proposes a point for the triangle of this shape.
bool proposes(Stage step, const MeshState& state, std::int32_t slot, const Shape& shape, Proposal& proposal);

/// Which rules certainly have nothing to say to a triangle; false tells nothing.
struct Quiet {
  bool step3 = true;
  bool step4 = true;
  bool step5 = true;
  bool bounds = true;  // of section 3: on the angles, and on the area ratio with each neighbour
};
/// All at once, by limits a little rougher than those of the rules, and without a division.
Quiet clearlyQuiet(const MeshState& state, std::int32_t slot, const Shape& shape);

}  // namespace triscope
