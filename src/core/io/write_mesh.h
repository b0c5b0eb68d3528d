// Writes a mesh to the file formats that other programs read.
#pragma once

#include <string>

#include "core/io/mesh_file.h"
#include "core/result.h"

namespace triscope {

struct MeshWriteOptions {
  bool msh2 = false;              // .msh as version 2.2 instead of 4.1
  bool (*cancelled)() = nullptr;  // asked now and then; true gives an error with ExitCode::cancelled
};

/// The format follows the extension: .msh .vtu .node (with .ele and .poly beside it) .su2 .off .obj. Numbers are
/// written with as many digits as it takes to read the same double back. On an error, or when cancelled, no file
/// of the set is touched (but for a disk that fails between two renames).
Status writeMesh(const std::string& path, const MeshFile& file, const MeshWriteOptions& options = {});

/// Whether the format of this name holds MeshFile::fields.
bool holdsFields(const std::string& path);

/// ".msh, .vtu, …" for messages and help.
std::string meshFormatsWritten();
bool isMeshPath(const std::string& path);

}  // namespace triscope
