// A mesh as files hold it: points, triangles, named groups of edges. What readers fill and writers take.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/base/point.h"

namespace triscope {

struct MeshFile {
  struct Edge {
    int a = 0;
    int b = 0;
    int group = 0;  // index into groups
    friend bool operator==(const Edge&, const Edge&) = default;
  };
  /// One number per triangle.
  struct Field {
    std::string name;
    std::vector<double> values;
    friend bool operator==(const Field&, const Field&) = default;
  };

  std::vector<Point> points;
  std::vector<std::array<int, 3>> triangles;  // indices of points, counter-clockwise when we wrote the file
  std::vector<Edge> edges;                    // boundary and inner edges
  std::vector<std::string> groups;            // names, in the order of the domain's loops
  std::vector<Point> holes;                   // a point inside each hole, for formats that want one
  std::vector<Field> fields;
  friend bool operator==(const MeshFile&, const MeshFile&) = default;
};

}  // namespace triscope
