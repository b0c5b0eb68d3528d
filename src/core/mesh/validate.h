// A checker that names what is broken and repairs nothing.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/mesh/mesh.h"

namespace triscope {

enum class Broken : std::uint8_t {
  link,         // neighbours disagree, or share other vertices than they say
  orientation,  // a triangle is not counter-clockwise (exact)
  delaunay,     // an unconstrained edge is not locally Delaunay (exact)
  boundary,     // a boundary edge is not an edge of the mesh, or a mesh border is no boundary edge
  vertex,       // vertexTriangle is wrong, or a vertex has no triangle
  duplicate,    // two vertices at the same place
  overlap,      // parts of the mesh lie over one another, or its borders touch (exact)
  domain,       // the mesh is not one of the domain it is held against
};

struct Violation {
  Broken what = Broken::link;
  Slot triangle;
  Vertex vertex;
  std::optional<Point> at;  // where to look; none for what is wrong as a whole
  std::string message;
};

/// At most `limit` violations, in a fixed order. Empty: the mesh is a valid constrained Delaunay triangulation.
std::vector<Violation> validate(const Mesh& mesh, std::size_t limit = 20);

}  // namespace triscope
