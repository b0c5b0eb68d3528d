// Reads plane triangle meshes that Triscope or other programs wrote.
#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/io/mesh_file.h"

namespace triscope {

/// The format follows the extension: .msh (Gmsh 2.2 and 4.1, ASCII), .vtu (ASCII), .node or .ele (both are read, and
/// .poly for the edges where there is one), .su2, .off, .obj. Errors: no_input when a file cannot be opened; bad_data
/// with the line, for what is damaged, not plane, or has elements other than triangles (points and edges aside). Every
/// index in the result is valid.
Result<MeshFile> readMesh(const std::string& path);

/// The readers behind it, from text; hostile input gives an error, never a crash. Errors name no file.
Result<MeshFile> parseMsh(std::string_view text);
Result<MeshFile> parseVtu(std::string_view text);
/// `poly` may be empty.
Result<MeshFile> parseTriangle(std::string_view node, std::string_view ele, std::string_view poly);
Result<MeshFile> parseSu2(std::string_view text);
Result<MeshFile> parseOff(std::string_view text);
Result<MeshFile> parseObj(std::string_view text);

/// ".msh, .vtu, …" for messages and help.
std::string meshFormatsRead();

}  // namespace triscope
