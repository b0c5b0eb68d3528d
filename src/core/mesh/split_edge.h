// A vertex put on an edge of the mesh, without a look at what is Delaunay.
#pragma once

#include "core/mesh/edit_log.h"

namespace triscope {

/// Puts a vertex at `at` into an edge that is not constrained: four triangles instead of two. The caller sees to it
/// that all four are counter-clockwise.
Vertex splitInnerEdge(Mesh& mesh, Half half, Point at, std::uint8_t density, EditLog& log);

/// Puts a vertex into the boundary edge `edge`, one side of which is `half`: two triangles instead of one on each side
/// that has one, and two boundary edges. `at` is where parameter t of the edge's curve lies.
Vertex splitBorderEdge(Mesh& mesh, Half half, EdgeId edge, double t, Point at, std::uint8_t density, EditLog& log);

}  // namespace triscope
