// Writes a mesh to the file formats that other programs read.
#pragma once

#include <string>
#include <vector>

#include "core/base/output_set.h"
#include "core/base/result.h"
#include "core/io/mesh_file.h"

namespace triscope {

struct MeshWriteOptions {
  bool msh2 = false;  // .msh as version 2.2 instead of 4.1
};

/// The format follows the extension: .msh .vtu .node (with .ele and .poly beside it) .su2 .off .obj. Numbers are
/// written with as many digits as it takes to read the same double back. On an error no file of the set is touched.
Status writeMesh(const std::string& path, const MeshFile& file, const MeshWriteOptions& options = {});
/// As part of a larger set, which is yet to be committed.
Status writeMesh(const std::string& path, const MeshFile& file, const MeshWriteOptions& options, OutputSet& set);

/// The files that writeMesh() writes for this name: the name itself, and what its format has beside it.
std::vector<std::string> meshFilesOf(const std::string& path);
/// Whether the format of this name holds MeshFile::fields.
bool holdsFields(const std::string& path);

/// ".msh, .vtu, …" for messages and help.
std::string meshFormatsWritten();
bool isMeshPath(const std::string& path);

}  // namespace triscope
