// Point location by walking, started near the answer.
#pragma once

#include <vector>

#include "core/mesh/mesh.h"

namespace triscope {

struct Location {
  Slot triangle;  // holds the point (closed), or the last one before the boundary
  Half blocked;   // constrained half-edge of `triangle` that the walk could not cross, if any
};

/// Visibility walk: crosses any edge that separates the triangle from p (O. Devillers, S. Pion and M. Teillaud,
/// "Walking in a triangulation", 2002). Ends in every Delaunay triangulation. Stops at a constrained edge.
/// `passed`, when given, gets the slots walked through, the first and the last included.
Location walkTo(const Mesh& mesh, Slot start, Point p, std::vector<Slot>* passed = nullptr);

/// Straight walk from a point inside `start` along the segment to p: says what p is hidden behind, if anything.
Location walkStraight(const Mesh& mesh, Slot start, Point from, Point p);

}  // namespace triscope
