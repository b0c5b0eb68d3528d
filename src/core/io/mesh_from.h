// A mesh read from a file, made into the kernel's, so that any mesh can be measured and validated.
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/io/mesh_file.h"
#include "core/mesh/mesh.h"

namespace triscope {

/// Links neighbours and lists as boundary edges the mesh's borders and the file's edges; BoundaryEdge::curve is the
/// group in the file, for borders that the file does not list the first number that is no group. Clockwise triangles
/// are turned round, and `notes` (when given) says so, as it does of points that no triangle uses (kind `removed`) and
/// of edges that the mesh lacks. Vertices keep the file's numbers; triangle ids are the file's order. Errors: no
/// triangles, two equal corners, or an edge with more than one triangle on a side.
Result<Mesh> meshFrom(const MeshFile& file, std::vector<std::string>* notes = nullptr);

}  // namespace triscope
