// How bad a region of the mesh is: what repair and the local refinements compare before and after.
#pragma once

#include <vector>

#include "core/mesh/mesh.h"

namespace triscope {

/// A bound counts as broken this much (relative) before it is, so that rounding cannot put a tie on the wrong side.
inline constexpr double kBoundMargin = 1e-9;

struct Badness {
  int broken = 0;           // triangles with R ≥ e (an angle ≤ 30°), and pairs with an area ratio ≥ 3
  int obtuse = 0;           // triangles with an angle above 90°
  double excess = 0.0;      // sum over the broken of how far they are beyond the bound
  double worst = 2.0;       // largest aspect ratio R/r
  double areaRatio = 1.0;   // largest, over pairs
  double edgeRatio = 1.0;   // largest, squared
  double radius = 1.0 / 3;  // largest circumradius over the shortest edge of its triangle, squared
  double shortest = 1e300;  // shortest edge, squared
};

/// Over the given live slots, and the pairs that at least one of them is in.
Badness badnessOf(const Mesh& mesh, const std::vector<Slot>& slots);
Badness badnessOf(const Mesh& mesh, Slot slot);

/// What one triangle adds to the badness of a mesh that is looked at whole: with a neighbour it breaks the bound on
/// area ratio when its slot is the lower of the two.
struct Breach {
  int broken = 0;
  double excess = 0.0;
  double shortest = 1e300;  // of its edges, squared
};
Breach breachOf(const Mesh& mesh, Slot slot);

/// True when the triangle breaks the bound on angles, or with a neighbour the bound on area ratio.
bool breaksBound(const Mesh& mesh, Slot slot);

}  // namespace triscope
