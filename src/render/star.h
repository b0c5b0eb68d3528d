// What stood in the place of a vertex's triangles before the vertex came.
#pragma once

#include <array>
#include <vector>

#include "core/mesh/edit.h"

namespace triscope {

/// Slots of the triangles of a star, and the vertices of the polygon around it: counter-clockwise, and open at a
/// boundary vertex, where the polygon runs from one boundary neighbour to the other.
std::vector<Slot> slotsOf(const Star& star);
std::vector<Vertex> rimVertices(const Mesh& mesh, const Star& star);

/// Edges (pairs of vertices) inside the rim of the Delaunay triangulation that the star's vertex was inserted into:
/// Bowyer and Watson's insertion removes exactly these. Unique unless four rim vertices lie on one circle.
std::vector<std::array<Vertex, 2>> edgesBefore(const Mesh& mesh, const std::vector<Vertex>& rim);

}  // namespace triscope
