// OFF and Wavefront OBJ.
#include "core/io/plane.h"
#include "core/io/read_mesh.h"

namespace triscope {
namespace {

constexpr const char* kOnlyTriangles = "only triangles are read: triangulate the faces first";

}  // namespace

Result<MeshFile> parseOff(std::string_view text) {
  TextScanner in(text, '#');
  MeshFile file;
  PlaneCheck plane;
  in.expect("OFF");
  const std::size_t points = in.count("the number of points", 4);
  const std::size_t faces = in.count("the number of faces", 4);
  in.integer("the number of edges", 0, TextScanner::kMost);
  for (std::size_t i = 0; i < points && !in.failed(); ++i) {
    const double x = in.number("x"), y = in.number("y");
    plane.take(in.number("z"), in);
    file.points.push_back({x, y});
  }
  const long long last = static_cast<long long>(points) - 1;
  for (std::size_t i = 0; i < faces && !in.failed(); ++i) {
    const long long corners = in.integer("the number of corners", 0, TextScanner::kMost);
    if (!in.failed() && corners != 3) in.fail(fmt::format("a face has {} corners", corners), kOnlyTriangles);
    std::array<int, 3> t{};
    for (int& v : t) v = static_cast<int>(in.integer("the number of a point", 0, std::max(0ll, last)));
    in.restOfLine();  // a colour may follow
    file.triangles.push_back(t);
  }
  if (!in.failed() && points == 0) in.fail("there are no points", "the file holds no mesh");
  if (in.failed()) return in.error();
  return file;
}

Result<MeshFile> parseObj(std::string_view text) {
  TextScanner in(text, '#');
  MeshFile file;
  PlaneCheck plane;
  while (!in.failed() && !in.atEnd()) {
    const std::string_view kind = in.word();
    if (kind == "v") {
      const double x = in.number("x"), y = in.number("y");
      plane.take(in.number("z"), in);
      file.points.push_back({x, y});
    } else if (kind == "f") {
      std::array<int, 3> t{};
      for (int& v : t) {
        // "7", "7/1", "7/1/2" or "7//2"; negative numbers count back from the last point.
        const std::string_view corner = in.word();
        TextScanner number(corner.substr(0, corner.find('/')));
        const long long most = static_cast<long long>(file.points.size());
        const long long n = number.integer("the number of a point", -most, most);
        if (number.failed() || n == 0) in.fail("a face names a point that does not come before it", "correct the file");
        v = static_cast<int>(n < 0 ? most + n : n - 1);
      }
      if (!in.failed() && !in.lineIsOver()) in.fail("a face has more than three corners", kOnlyTriangles);
      file.triangles.push_back(t);
    }
    in.restOfLine();
  }
  if (!in.failed() && file.points.empty()) in.fail("there are no points", "the file holds no mesh");
  if (in.failed()) return in.error();
  return file;
}

}  // namespace triscope
