// The triangles around a vertex, and what stood in their place before the vertex came.
#pragma once

#include <vector>

#include "core/mesh/mesh.h"

namespace triscope {

/// The live triangles around a vertex, counter-clockwise. `rim` is the polygon around them; at a boundary vertex it
/// is open and runs from the boundary neighbour on one side to the one on the other.
struct Star {
  std::vector<std::int32_t> slots;
  std::vector<std::int32_t> rim;  // vertices
  bool closed = false;
};
Star starOf(const Mesh& mesh, std::int32_t vertex);

/// Edges (pairs of vertices) inside the rim of the Delaunay triangulation that the star's vertex was inserted into:
/// Bowyer and Watson's insertion removes exactly these. Unique unless four rim vertices lie on one circle.
std::vector<std::array<std::int32_t, 2>> edgesBefore(const Mesh& mesh, const Star& star);

}  // namespace triscope
