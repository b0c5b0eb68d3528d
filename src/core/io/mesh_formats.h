// One writer per format, each a function from a mesh to text, and the table that finds it by extension.
#pragma once

#include <string_view>
#include <vector>

#include "core/base/text_sink.h"
#include "core/io/mesh_file.h"

namespace triscope {

/// Per point, the number from 1 of the first group that has an edge there; 0 inside.
std::vector<int> pointMarkers(const MeshFile& file);

void writeMsh4(const MeshFile& file, TextSink& out);
void writeMsh2(const MeshFile& file, TextSink& out);
void writeVtu(const MeshFile& file, TextSink& out);
void writeNode(const MeshFile& file, TextSink& out);
void writeEle(const MeshFile& file, TextSink& out);
void writePoly(const MeshFile& file, TextSink& out);
void writeSu2(const MeshFile& file, TextSink& out);
void writeOff(const MeshFile& file, TextSink& out);
void writeObj(const MeshFile& file, TextSink& out);

}  // namespace triscope
