// Any bytes as a mesh file: an error or a mesh that can be linked, measured, validated and written, never a crash.
// The first byte chooses the format.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/io/mesh_from.h"
#include "core/io/read_mesh.h"
#include "core/mesh/validate.h"
#include "core/quality/quality.h"

namespace {

using namespace triscope;

void require(bool condition) {
  if (!condition) std::abort();
}

/// What readMesh() promises of its result.
void requireValidIndices(const MeshFile& file) {
  const auto isPoint = [&](int v) { return v >= 0 && static_cast<std::size_t>(v) < file.points.size(); };
  for (const auto& t : file.triangles) require(isPoint(t[0]) && isPoint(t[1]) && isPoint(t[2]));
  for (const MeshFile::Edge& edge : file.edges) {
    require(isPoint(edge.a) && isPoint(edge.b));
    require(edge.group >= 0 && static_cast<std::size_t>(edge.group) < file.groups.size());
  }
  for (const MeshFile::Field& field : file.fields) require(field.values.size() == file.triangles.size());
}

Result<MeshFile> parse(std::uint8_t format, std::string_view text) {
  switch (format % 6) {
    case 0:
      return parseMsh(text);
    case 1:
      return parseVtu(text);
    case 2:
      return parseOff(text);
    case 3:
      return parseObj(text);
    case 5:
      return parseSu2(text);
    default: {
      // The three files of Triangle, one after the other with a '|' between.
      const std::size_t first = text.find('|'), second = text.find('|', first == text.npos ? first : first + 1);
      if (second == text.npos) return parseTriangle(text, text, {});
      return parseTriangle(text.substr(0, first), text.substr(first + 1, second - first - 1), text.substr(second + 1));
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const auto file = parse(data[0], {reinterpret_cast<const char*>(data) + 1, size - 1});
  if (!file) {
    require(!file.error().message.empty() && !file.error().hint.empty());
    return 0;
  }
  requireValidIndices(*file);
  const auto mesh = meshFrom(*file);
  if (!mesh) return 0;
  require(measure(*mesh).triangles == file->triangles.size());
  for (const Violation& v : validate(*mesh)) require(v.what != Broken::link && v.what != Broken::boundary);
  return 0;
}
