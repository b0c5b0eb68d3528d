// The five insertion rules of the paper (section 3.1), side by side.
#pragma once

#include "core/method/state.h"

namespace triscope {

struct Proposal {
  Point at;
  double measured = 0.0;  // R, or |p5 p4| in step 5
  double limit = 0.0;     // what it is not below
  double nearest = 0.0;   // the new point must be at least this far from every vertex
  Slot other;             // adjacent triangle that the limit came from, if any
};

/// True when the rule of `step` (step1 … step5) proposes a point for the triangle.
bool proposes(Stage step, const MeshState& state, Slot slot, LeafPath& path, Proposal& proposal);

/// Which rules certainly have nothing to say to a triangle; false tells nothing.
struct Quiet {
  bool step2 = true;
  bool step3 = true;
  bool step4 = true;
  bool step5 = true;
  bool bounds = true;  // of section 3: on the angles, and on the area ratio with each neighbour

  [[nodiscard]] bool of(Stage step) const {
    return step == Stage::step2 ? step2 : step == Stage::step3 ? step3 : step == Stage::step4 ? step4 : step5;
  }
};
/// All at once, by limits a little rougher than those of the rules, and without a division.
Quiet clearlyQuiet(const MeshState& state, Slot slot);

}  // namespace triscope
