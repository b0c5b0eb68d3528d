// The .node, .ele and .poly files of Triangle, counted from 1. A boundary marker is the number of the group, from 1;
// 0 is the interior.
#include <vector>

#include "core/io/mesh_formats.h"

namespace triscope {

std::vector<int> pointMarkers(const MeshFile& file) {
  std::vector<int> marker(file.points.size(), 0);
  for (const MeshFile::Edge& edge : file.edges) {
    for (const int end : {edge.a, edge.b}) {
      int& m = marker[static_cast<std::size_t>(end)];
      if (m == 0) m = edge.group + 1;
    }
  }
  return marker;
}

void writeNode(const MeshFile& file, TextSink& out) {
  const std::vector<int> marker = pointMarkers(file);
  out.print(FMT_COMPILE("{} 2 0 1\n"), file.points.size());
  for (std::size_t i = 0; i < file.points.size(); ++i) {
    out.print(FMT_COMPILE("{} {} {} {}\n"), i + 1, file.points[i].x, file.points[i].y, marker[i]);
  }
}

void writeEle(const MeshFile& file, TextSink& out) {
  out.print(FMT_COMPILE("{} 3 0\n"), file.triangles.size());
  for (std::size_t i = 0; i < file.triangles.size(); ++i) {
    const auto& t = file.triangles[i];
    out.print(FMT_COMPILE("{} {} {} {}\n"), i + 1, t[0] + 1, t[1] + 1, t[2] + 1);
  }
}

void writePoly(const MeshFile& file, TextSink& out) {
  for (std::size_t g = 0; g < file.groups.size(); ++g) {
    std::string name = file.groups[g];
    for (char& c : name) c = static_cast<unsigned char>(c) < 0x20 ? '_' : c;
    out.print(FMT_COMPILE("# marker {}: {}\n"), g + 1, name);
  }
  out.print(FMT_COMPILE("0 2 0 1\n{} 1\n"), file.edges.size());
  for (std::size_t i = 0; i < file.edges.size(); ++i) {
    const MeshFile::Edge& edge = file.edges[i];
    out.print(FMT_COMPILE("{} {} {} {}\n"), i + 1, edge.a + 1, edge.b + 1, edge.group + 1);
  }
  out.print(FMT_COMPILE("{}\n"), file.holes.size());
  for (std::size_t i = 0; i < file.holes.size(); ++i)
    out.print(FMT_COMPILE("{} {} {}\n"), i + 1, file.holes[i].x, file.holes[i].y);
}

}  // namespace triscope
