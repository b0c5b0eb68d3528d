// The .node, .ele and .poly files of Triangle. The first node's number, 0 or 1, says where counting starts.
#include <algorithm>
#include <map>

#include "core/base/text_scanner.h"
#include "core/io/read_mesh.h"

namespace triscope {
namespace {

Error inPart(Error error, const char* part) {
  error.message = fmt::format("{} file, {}", part, error.message);
  return error;
}

}  // namespace

Result<MeshFile> parseTriangle(std::string_view node, std::string_view ele, std::string_view poly) {
  MeshFile file;
  long long first = 1;
  {
    TextScanner in(node, '#');
    const std::size_t count = in.count("the number of nodes", 6);
    in.expect("2");
    const std::size_t attributes = in.count("the number of attributes", 1);
    const long long markers = in.integer("the number of markers", 0, 1);
    for (std::size_t i = 0; i < count && !in.failed(); ++i) {
      const long long number = in.integer("the number of a node", 0, TextScanner::kMost);
      if (i == 0) first = number;
      if (number != first + static_cast<long long>(i)) in.fail("the nodes are not numbered in order", "renumber them");
      const double x = in.number("x"), y = in.number("y");
      file.points.push_back({x, y});
      for (std::size_t a = 0; a < attributes && !in.failed(); ++a) in.number("an attribute");
      if (markers == 1) in.integer("a marker", -TextScanner::kMost, TextScanner::kMost);
    }
    if (!in.failed() && first > 1) in.fail("the first node is neither 0 nor 1", "renumber the nodes");
    if (in.failed()) return inPart(in.error(), ".node");
  }
  const auto nodeIndex = [&](TextScanner& in) {
    const long long last = first + static_cast<long long>(file.points.size()) - 1;
    return static_cast<int>(in.integer("the number of a node", first, std::max(first, last)) - first);
  };
  if (file.points.empty()) {
    return Error{.message = ".node file: there are no nodes", .hint = "the file holds no mesh", .file = {}, .loop = {}};
  }
  {
    TextScanner in(ele, '#');
    const std::size_t count = in.count("the number of triangles", 8);
    const long long corners = in.integer("the number of corners", 3, 6);
    if (!in.failed() && corners != 3) in.fail("the triangles have six nodes", "write them with three");
    const std::size_t attributes = in.count("the number of attributes", 1);
    for (std::size_t i = 0; i < count && !in.failed(); ++i) {
      in.integer("the number of a triangle", 0, TextScanner::kMost);
      const int a = nodeIndex(in), b = nodeIndex(in), c = nodeIndex(in);
      file.triangles.push_back({a, b, c});
      for (std::size_t k = 0; k < attributes && !in.failed(); ++k) in.number("an attribute");
    }
    if (in.failed()) return inPart(in.error(), ".ele");
  }
  if (poly.empty()) return file;
  {
    TextScanner in(poly, '#');
    if (in.integer("the number of nodes", 0, TextScanner::kMost) != 0)
      in.fail("it lists nodes of its own", "remove it");
    for (int i = 0; i < 3; ++i) in.integer("a count", 0, TextScanner::kMost);
    const std::size_t count = in.count("the number of segments", 6);
    const long long markers = in.integer("the number of markers", 0, 1);
    std::vector<long long> marks;
    for (std::size_t i = 0; i < count && !in.failed(); ++i) {
      in.integer("the number of a segment", 0, TextScanner::kMost);
      const int a = nodeIndex(in), b = nodeIndex(in);
      file.edges.push_back({a, b, 0});
      marks.push_back(markers == 1 ? in.integer("a marker", -TextScanner::kMost, TextScanner::kMost) : 0);
    }
    const std::size_t holes = in.count("the number of holes", 6);
    for (std::size_t i = 0; i < holes && !in.failed(); ++i) {
      in.integer("the number of a hole", 0, TextScanner::kMost);
      const double x = in.number("x"), y = in.number("y");
      file.holes.push_back({x, y});
    }
    if (in.failed()) return inPart(in.error(), ".poly");
    std::map<long long, int> groups;
    for (const long long mark : marks) groups.emplace(mark, 0);
    for (auto& [mark, group] : groups) {
      group = static_cast<int>(file.groups.size());
      file.groups.push_back(fmt::format("marker {}", mark));
    }
    for (std::size_t i = 0; i < marks.size(); ++i) file.edges[i].group = groups.at(marks[i]);
  }
  return file;
}

}  // namespace triscope
