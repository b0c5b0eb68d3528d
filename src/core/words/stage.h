// The stages of the method in the order they run. Their rows, and which of them a method is made of, are in
// core/method/method.h.
#pragma once

#include <cstdint>

namespace triscope {

enum class Stage : std::uint8_t {
  constraints,    // Figure 1 (a)
  quadtree,       // Figure 1 (b)
  density,        // Figure 1 (c, d)
  boundary,       // Figure 4 (a)
  triangulation,  // Figure 4 (b), initial Bowyer-Watson
  recovery,       // every boundary edge made present
  carve,          // Figure 4 (b), triangles outside removed
  front1,         // Figure 4 (c)
  front2,         // Figure 4 (c)
  rows,           // our own: in place of the two fronts and step 1, rows of points from the boundary inwards
  step1,          // Figure 4 (d)
  step2,          // a round is steps 2, 3, 4, 5
  step3,
  step4,
  step5,     // Figure 4 (e) once a round inserts nothing
  repair,    // our own: mends what the steps had to refuse
  refine,    // step 6, Figure 4 (f)
  optimise,  // our own: no angle, area ratio or edge ratio beyond what the dial asks for
  finished,
};

inline constexpr int kStageCount = static_cast<int>(Stage::finished) + 1;

}  // namespace triscope
