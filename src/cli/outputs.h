// Output files by their extension: meshes and pictures.
#pragma once

#include <string>
#include <vector>

#include "core/result.h"
#include "core/stage.h"
#include "core/state.h"

namespace triscope {

/// ".svg, .png"
std::string figureFormats();
bool isFigurePath(const std::string& path);

/// Refuses an extension that is not known, and a mesh file of a run that ends at `last`, before there is a mesh.
Status checkOutputs(const std::vector<std::string>& paths, Stage last);
/// Refuses a path that cannot be written, before a long run rather than after it. Touches nothing.
Status probeOutputs(const std::vector<std::string>& paths);
/// Writes the mesh of the state in the format of each path.
Status writeOutputs(const std::vector<std::string>& paths, const MeshState& state, Stage last, bool msh2);

}  // namespace triscope
