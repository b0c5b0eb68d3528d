#include "core/mesh/remove.h"

#include "core/base/assert.h"
#include "core/geometry/predicates.h"
#include "core/mesh/edit.h"

namespace triscope {
namespace {

// Corner k of the rim polygon is an ear that no other corner's circle test forbids. Two corners are, as long as there
// are four: the vertex that is gone sees every corner, as none of its edges is a wall, and so the circles of its
// triangles hold no corner. Each side of the polygon thus has a circle that is empty of corners, and what cuts off an
// ear has one too. Such sides are all in one Delaunay triangulation of the corners; its part within the polygon has two
// ears.
bool delaunayEar(const Mesh& mesh, const std::vector<Vertex>& polygon, std::size_t k) {
  const std::size_t n = polygon.size();
  const std::size_t before = k == 0 ? n - 1 : k - 1;
  const std::size_t after = k + 1 == n ? 0 : k + 1;
  const Point a = pointOf(mesh, polygon[before]), b = pointOf(mesh, polygon[k]), c = pointOf(mesh, polygon[after]);
  if (orient2d(a, b, c) <= 0) return false;
  for (std::size_t i = 0; i < n; ++i) {
    if (i != before && i != k && i != after && incircle(a, b, c, pointOf(mesh, polygon[i])) > 0) return false;
  }
  return true;
}

}  // namespace

bool removeVertex(Mesh& mesh, Vertex vertex) {
  Star star;
  std::vector<Vertex> polygon;  // corners counter-clockwise
  std::vector<Half> outside;    // half-edge beyond the edge from corner k to corner k + 1
  std::vector<std::uint8_t> walls;
  if (mesh.vertexEdge[vertex].exists()) return false;
  starOf(mesh, vertex, star);
  if (!star.closed || star.rim.size() < 3) return false;
  for (const Half rim : star.rim) {
    polygon.push_back(startOf(mesh, rim));
    outside.push_back(oppositeOf(mesh, rim));
    walls.push_back(constrained(mesh, rim) ? 1 : 0);
  }
  for (const Half rim : star.rim) killTriangle(mesh, triangleOf(rim));
  mesh.kinds[vertex] = VertexKind::removed;
  mesh.vertexTriangle[vertex] = {};
  const auto hang = [&](Half half, std::size_t k) {
    link(mesh, half, outside[k]);
    if (outside[k].exists()) mesh.tested[triangleOf(outside[k])] = 0;
    if (walls[k] != 0) constrain(mesh, half);
  };
  while (polygon.size() > 3) {
    const std::size_t n = polygon.size();
    std::size_t ear = 0;
    while (ear < n && !delaunayEar(mesh, polygon, ear)) ++ear;
    TRISCOPE_CHECK(ear < n, "what a vertex leaves in a Delaunay triangulation has a Delaunay ear");
    const std::size_t before = ear == 0 ? n - 1 : ear - 1;
    const std::size_t after = ear + 1 == n ? 0 : ear + 1;
    const Slot slot = addTriangle(mesh, polygon[before], polygon[ear], polygon[after]);
    hang(halfOf(slot, 2), before);
    hang(halfOf(slot, 0), ear);
    // The ear's third edge takes the place of the two it covers.
    outside[before] = halfOf(slot, 1);
    walls[before] = 0;
    const auto gone = static_cast<std::ptrdiff_t>(ear);
    polygon.erase(polygon.begin() + gone);
    outside.erase(outside.begin() + gone);
    walls.erase(walls.begin() + gone);
  }
  const Slot slot = addTriangle(mesh, polygon[0], polygon[1], polygon[2]);
  hang(halfOf(slot, 2), 0);
  hang(halfOf(slot, 0), 1);
  hang(halfOf(slot, 1), 2);
  mesh.lastTriangle = slot;
  return true;
}

}  // namespace triscope
