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
  out.print("<?xml version=\"1.0\"?>\n");
  out.print("<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n");
  out.print("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n", file.points.size(), file.triangles.size());

  out.print("<Points>\n<DataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\" format=\"ascii\">\n");
  for (const Point p : file.points) out.print("{} {} 0\n", p.x, p.y);
  out.print("</DataArray>\n</Points>\n");

  out.print("<Cells>\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n");
  for (const auto& t : file.triangles) out.print("{} {} {}\n", t[0], t[1], t[2]);
  out.print("</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n");
  for (std::size_t i = 1; i <= file.triangles.size(); ++i) out.print("{}\n", 3 * i);
  out.print("</DataArray>\n<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">\n");
  for (std::size_t i = 0; i < file.triangles.size(); ++i) out.print("{}\n", kVtkTriangle);
  out.print("</DataArray>\n</Cells>\n");

  if (!file.edges.empty()) {
    out.print("<PointData>\n<DataArray type=\"Int32\" Name=\"boundary\" format=\"ascii\">\n");
    for (const int marker : pointMarkers(file)) out.print("{}\n", marker);
    out.print("</DataArray>\n</PointData>\n");
  }
  if (!file.fields.empty()) out.print("<CellData>\n");
  for (const MeshFile::Field& field : file.fields) {
    out.print("<DataArray type=\"Float64\" Name=\"{}\" format=\"ascii\">\n", xmlText(field.name));
    for (const double value : field.values) out.print("{}\n", value);
    out.print("</DataArray>\n");
  }
  if (!file.fields.empty()) out.print("</CellData>\n");
  out.print("</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
}

}  // namespace triscope
