#include "ui/model/export_format.h"

#include <array>
#include <filesystem>

namespace triscope {

std::span<const ExportFormat> exportFormats() {
  using Content = ExportFormat::Content;
  static constexpr std::array<ExportFormat, 10> kFormats{{
      {".msh", Content::mesh, "Gmsh 4.1, boundary edges as named groups"},
      {".vtu", Content::mesh, "VTK, with the quality of each triangle"},
      {".su2", Content::mesh, "SU2, with markers"},
      {".node", Content::mesh, "Triangle's .node, .ele and .poly"},
      {".off", Content::mesh, "Object File Format"},
      {".obj", Content::mesh, "Wavefront"},
      {".json", Content::domain, "the domain, with its density constraints"},
      {".svg", Content::picture, "picture of what is in view, as vectors"},
      {".png", Content::picture, "picture of what is in view, as pixels"},
      {".csv", Content::sweep, "the sweep over \xCF\x89 and \xCE\xB8, a line for each pair"},
  }};
  return kFormats;
}

const ExportFormat* exportFormatOf(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  for (const ExportFormat& format : exportFormats())
    if (extension == format.extension) return &format;
  return nullptr;
}

}  // namespace triscope
