// Gmsh's ASCII formats 4.1 and 2.2 (Gmsh reference manual, "MSH file format"). Every group of edges is a named
// physical curve, the triangles are the physical surface "domain". Tags count from 1.
#include <span>

#include "core/io/edge_groups.h"
#include "core/io/mesh_formats.h"

namespace triscope {
namespace {

constexpr int kLine = 1;  // Gmsh's element types
constexpr int kTriangle = 2;

/// Names stand between double quotes and have no escapes.
std::string quotable(const std::string& name) {
  std::string out;
  for (const char c : name) out += c == '"' || static_cast<unsigned char>(c) < 0x20 ? '_' : c;
  return out;
}

void writePhysicalNames(const MeshFile& file, TextSink& out) {
  out.print(FMT_COMPILE("$PhysicalNames\n{}\n"), file.groups.size() + 1);
  for (std::size_t g = 0; g < file.groups.size(); ++g)
    out.print(FMT_COMPILE("1 {} \"{}\"\n"), g + 1, quotable(file.groups[g]));
  out.print(FMT_COMPILE("2 {} \"domain\"\n$EndPhysicalNames\n"), file.groups.size() + 1);
}

Box boundsOf(const MeshFile& file) {
  Box box;
  for (const Point p : file.points) box.include(p);
  return box.empty() ? Box{{0, 0}, {0, 0}} : box;
}

void writeEntities(const MeshFile& file, const EdgeGroups& groups, TextSink& out) {
  out.print(FMT_COMPILE("$Entities\n0 {} 1 0\n"), file.groups.size());
  for (std::size_t g = 0; g < file.groups.size(); ++g) {
    Box box;
    for (const MeshFile::Edge& edge : groups.of(g)) {
      box.include(file.points[static_cast<std::size_t>(edge.a)]);
      box.include(file.points[static_cast<std::size_t>(edge.b)]);
    }
    if (box.empty()) box = boundsOf(file);
    out.print(FMT_COMPILE("{} {} {} 0 {} {} 0 1 {} 0\n"), g + 1, box.lo.x, box.lo.y, box.hi.x, box.hi.y, g + 1);
  }
  const Box box = boundsOf(file);
  out.print(FMT_COMPILE("1 {} {} 0 {} {} 0 1 {} {}"), box.lo.x, box.lo.y, box.hi.x, box.hi.y, file.groups.size() + 1,
            file.groups.size());
  for (std::size_t g = 0; g < file.groups.size(); ++g) out.print(FMT_COMPILE(" {}"), g + 1);
  out.print(FMT_COMPILE("\n$EndEntities\n"));
}

}  // namespace

void writeMsh4(const MeshFile& file, TextSink& out) {
  out.print(FMT_COMPILE("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"));
  writePhysicalNames(file, out);
  const EdgeGroups groups(file);
  writeEntities(file, groups, out);

  const std::size_t points = file.points.size();
  out.print(FMT_COMPILE("$Nodes\n1 {} 1 {}\n2 1 0 {}\n"), points, points, points);
  for (std::size_t i = 0; i < points; ++i) out.print(FMT_COMPILE("{}\n"), i + 1);
  for (const Point p : file.points) out.print(FMT_COMPILE("{} {} 0\n"), p.x, p.y);
  out.print(FMT_COMPILE("$EndNodes\n"));

  std::size_t blocks = file.triangles.empty() ? 0u : 1u;
  for (std::size_t g = 0; g < file.groups.size(); ++g) blocks += groups.of(g).empty() ? 0u : 1u;
  const std::size_t elements = file.edges.size() + file.triangles.size();
  out.print(FMT_COMPILE("$Elements\n{} {} 1 {}\n"), blocks, elements, elements);
  std::size_t tag = 1;
  for (std::size_t g = 0; g < file.groups.size(); ++g) {
    const std::span<const MeshFile::Edge> edges = groups.of(g);
    if (edges.empty()) continue;
    out.print(FMT_COMPILE("1 {} {} {}\n"), g + 1, kLine, edges.size());
    for (const MeshFile::Edge& edge : edges) out.print(FMT_COMPILE("{} {} {}\n"), tag++, edge.a + 1, edge.b + 1);
  }
  if (!file.triangles.empty()) out.print(FMT_COMPILE("2 1 {} {}\n"), kTriangle, file.triangles.size());
  for (const auto& t : file.triangles) out.print(FMT_COMPILE("{} {} {} {}\n"), tag++, t[0] + 1, t[1] + 1, t[2] + 1);
  out.print(FMT_COMPILE("$EndElements\n"));
}

void writeMsh2(const MeshFile& file, TextSink& out) {
  out.print(FMT_COMPILE("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"));
  writePhysicalNames(file, out);
  out.print(FMT_COMPILE("$Nodes\n{}\n"), file.points.size());
  for (std::size_t i = 0; i < file.points.size(); ++i) {
    out.print(FMT_COMPILE("{} {} {} 0\n"), i + 1, file.points[i].x, file.points[i].y);
  }
  out.print(FMT_COMPILE("$EndNodes\n$Elements\n{}\n"), file.edges.size() + file.triangles.size());
  std::size_t tag = 1;
  for (const MeshFile::Edge& edge : file.edges) {
    out.print(FMT_COMPILE("{} {} 2 {} {} {} {}\n"), tag++, kLine, edge.group + 1, edge.group + 1, edge.a + 1,
              edge.b + 1);
  }
  for (const auto& t : file.triangles) {
    out.print(FMT_COMPILE("{} {} 2 {} 1 {} {} {}\n"), tag++, kTriangle, file.groups.size() + 1, t[0] + 1, t[1] + 1,
              t[2] + 1);
  }
  out.print(FMT_COMPILE("$EndElements\n"));
}

}  // namespace triscope
