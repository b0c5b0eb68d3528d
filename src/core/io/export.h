// From a state to what is written to a file.
#pragma once

#include "core/io/mesh_file.h"
#include "core/state.h"

namespace triscope {

/// The mesh of a state without the box around everything. Vertices keep their order, triangles run by id, edges by
/// loop and along it: the same state gives the same file. Fields: id, aspect, edge_ratio, min_angle, max_angle.
MeshFile exportMesh(const MeshState& state);

}  // namespace triscope
