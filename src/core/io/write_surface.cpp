// Formats of one screen each: SU2's native mesh, OFF and Wavefront OBJ.
#include "core/io/edge_groups.h"
#include "core/io/mesh_formats.h"

namespace triscope {

void writeSu2(const MeshFile& file, TextSink& out) {
  constexpr int kVtkLine = 3;  // VTK's cell types
  constexpr int kVtkTriangle = 5;
  out.print(FMT_COMPILE("NDIME= 2\nNELEM= {}\n"), file.triangles.size());
  for (std::size_t i = 0; i < file.triangles.size(); ++i) {
    const auto& t = file.triangles[i];
    out.print(FMT_COMPILE("{} {} {} {} {}\n"), kVtkTriangle, t[0], t[1], t[2], i);
  }
  out.print(FMT_COMPILE("NPOIN= {}\n"), file.points.size());
  for (std::size_t i = 0; i < file.points.size(); ++i)
    out.print(FMT_COMPILE("{} {} {}\n"), file.points[i].x, file.points[i].y, i);
  out.print(FMT_COMPILE("NMARK= {}\n"), file.groups.size());
  const EdgeGroups groups(file);
  for (std::size_t g = 0; g < file.groups.size(); ++g) {
    std::string tag = file.groups[g];
    for (char& c : tag) c = static_cast<unsigned char>(c) <= 0x20 || c == '%' || c == '=' ? '_' : c;
    out.print(FMT_COMPILE("MARKER_TAG= {}\nMARKER_ELEMS= {}\n"), tag, groups.of(g).size());
    for (const MeshFile::Edge& edge : groups.of(g)) out.print(FMT_COMPILE("{} {} {}\n"), kVtkLine, edge.a, edge.b);
  }
}

void writeOff(const MeshFile& file, TextSink& out) {
  out.print(FMT_COMPILE("OFF\n{} {} 0\n"), file.points.size(), file.triangles.size());
  for (const Point p : file.points) out.print(FMT_COMPILE("{} {} 0\n"), p.x, p.y);
  for (const auto& t : file.triangles) out.print(FMT_COMPILE("3 {} {} {}\n"), t[0], t[1], t[2]);
}

void writeObj(const MeshFile& file, TextSink& out) {
  for (const Point p : file.points) out.print(FMT_COMPILE("v {} {} 0\n"), p.x, p.y);
  for (const auto& t : file.triangles) out.print(FMT_COMPILE("f {} {} {}\n"), t[0] + 1, t[1] + 1, t[2] + 1);
}

}  // namespace triscope
