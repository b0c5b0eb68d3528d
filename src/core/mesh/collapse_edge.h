// An edge taken out of the mesh with one of its ends, without a look at what is Delaunay.
#pragma once

#include "core/mesh/edit_log.h"

namespace triscope {

/// Merges `gone` into `stays` along the edge between them; the triangles beside the edge vanish. Where to is the
/// caller's to say afterwards, and that no triangle turns over. `gone` is inside the domain, or on the boundary
/// between two edges of one curve with `stays` the far end of one of them: these become one. False, with nothing
/// changed, where the outcome would not be a triangulation.
bool collapseEdge(Mesh& mesh, Vertex gone, Vertex stays, EditLog& log);

}  // namespace triscope
