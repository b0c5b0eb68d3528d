// Point location by walking, started near the answer.
#pragma once

#include <vector>

#include "core/mesh/mesh.h"

namespace triscope {

struct Location {
  std::int32_t triangle = -1;  // holds the point (closed), or the last one before the boundary
  std::int32_t blocked = -1;   // constrained half-edge of `triangle` that the walk could not cross, -1 when none
};

/// Visibility walk: crosses any edge that separates the triangle from p (O. Devillers, S. Pion and M. Teillaud,
/// "Walking in a triangulation", 2002). Ends in every Delaunay triangulation. Stops at a constrained edge.
/// `passed`, when given, gets the slots walked through, the first and the last included.
Location walkTo(const Mesh& mesh, std::int32_t start, Point p, std::vector<std::int32_t>* passed = nullptr);

/// Straight walk from a point inside `start` along the segment to p: says what p is hidden behind, if anything.
Location walkStraight(const Mesh& mesh, std::int32_t start, Point from, Point p);

}  // namespace triscope
