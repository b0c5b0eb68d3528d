// From a state to what is written to a file.
#pragma once

#include "core/io/mesh_file.h"
#include "core/method/state.h"

namespace triscope {

/// The mesh of a state without the box around everything. Vertices keep their order, triangles run by id, edges by
/// loop and along it: the same state gives the same file. Fields, which cost as much as the rest and which few formats
/// hold: id, aspect, area_ratio, edge_ratio, min_angle, max_angle.
enum class Fields : bool { no, yes };
MeshFile exportMesh(const MeshState& state, Fields fields = Fields::yes);

}  // namespace triscope
