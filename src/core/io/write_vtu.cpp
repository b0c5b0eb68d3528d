// VTK's XML unstructured grid, ASCII: triangles with the fields as cell data, and which group a point belongs to.
#include "core/io/mesh_formats.h"

namespace triscope {
namespace {

constexpr int kVtkTriangle = 5;

std::string xmlText(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

}  // namespace

void writeVtu(const MeshFile& file, TextSink& out) {
  out.print(FMT_COMPILE("<?xml version=\"1.0\"?>\n"));
  out.print(FMT_COMPILE(
      "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n"));
  out.print(FMT_COMPILE("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n"), file.points.size(),
            file.triangles.size());

  out.print(FMT_COMPILE(
      "<Points>\n<DataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\" format=\"ascii\">\n"));
  for (const Point p : file.points) out.print(FMT_COMPILE("{} {} 0\n"), p.x, p.y);
  out.print(FMT_COMPILE("</DataArray>\n</Points>\n"));

  out.print(FMT_COMPILE("<Cells>\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n"));
  for (const auto& t : file.triangles) out.print(FMT_COMPILE("{} {} {}\n"), t[0], t[1], t[2]);
  out.print(FMT_COMPILE("</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n"));
  for (std::size_t i = 1; i <= file.triangles.size(); ++i) out.print(FMT_COMPILE("{}\n"), 3 * i);
  out.print(FMT_COMPILE("</DataArray>\n<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">\n"));
  for (std::size_t i = 0; i < file.triangles.size(); ++i) out.print(FMT_COMPILE("{}\n"), kVtkTriangle);
  out.print(FMT_COMPILE("</DataArray>\n</Cells>\n"));

  if (!file.edges.empty()) {
    out.print(FMT_COMPILE("<PointData>\n<DataArray type=\"Int32\" Name=\"boundary\" format=\"ascii\">\n"));
    for (const int marker : pointMarkers(file)) out.print(FMT_COMPILE("{}\n"), marker);
    out.print(FMT_COMPILE("</DataArray>\n</PointData>\n"));
  }
  if (!file.fields.empty()) out.print(FMT_COMPILE("<CellData>\n"));
  for (const MeshFile::Field& field : file.fields) {
    out.print(FMT_COMPILE("<DataArray type=\"Float64\" Name=\"{}\" format=\"ascii\">\n"), xmlText(field.name));
    for (const double value : field.values) out.print(FMT_COMPILE("{}\n"), value);
    out.print(FMT_COMPILE("</DataArray>\n"));
  }
  if (!file.fields.empty()) out.print(FMT_COMPILE("</CellData>\n"));
  out.print(FMT_COMPILE("</Piece>\n</UnstructuredGrid>\n</VTKFile>\n"));
}

}  // namespace triscope
