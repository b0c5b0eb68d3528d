// Output files by their extension: meshes and pictures.
#pragma once

#include <string>
#include <vector>

#include "core/base/output_set.h"
#include "core/base/result.h"
#include "core/io/write_mesh.h"
#include "core/method/state.h"
#include "core/words/stage.h"

namespace triscope {

/// ".svg, .png"
std::string figureFormats();
bool isFigurePath(const std::string& path);

/// Refuses an extension that is not known, and a mesh file of a run that ends at `last`, before there is a mesh.
Status checkOutputs(const std::vector<std::string>& paths, Stage last);
/// Opens all that these names stand for, before a long run rather than after it.
Status openOutputs(const std::vector<std::string>& paths, OutputSet& set);
/// Writes the mesh of the state in the format of each path.
Status writeOutputs(const std::vector<std::string>& paths, const MeshState& state, Stage last,
                    const MeshWriteOptions& options, OutputSet& set);
/// The files that a name stands for: one, or those of a format of several.
std::vector<std::string> filesOf(const std::string& path);

}  // namespace triscope
