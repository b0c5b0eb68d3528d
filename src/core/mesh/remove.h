// Taking a vertex out of a Delaunay triangulation.
#pragma once

#include "core/mesh/mesh.h"

namespace triscope {

/// Removes an inner vertex that no constrained edge ends in, and fills its star with Delaunay triangles by cutting
/// ears (exact tests, degree³ at most). Returns false, changing nothing, when the vertex may not be removed.
bool removeVertex(Mesh& mesh, Vertex vertex);

}  // namespace triscope
