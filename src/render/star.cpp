#include "render/star.h"

#include <algorithm>

#include "core/geometry/predicates.h"

namespace triscope {
namespace {

int cornerOfVertex(const Triangle& t, std::int32_t vertex) {
  for (int i = 0; i < 3; ++i) {
    if (t.v[static_cast<std::size_t>(i)] == vertex) return i;
  }
  return -1;
}

}  // namespace

Star starOf(const Mesh& mesh, std::int32_t vertex) {
  Star star;
  if (vertex < 0 || static_cast<std::size_t>(vertex) >= mesh.vertexTriangle.size()) return star;
  const std::int32_t first = mesh.vertexTriangle[static_cast<std::size_t>(vertex)];
  if (first < 0 || !mesh.alive(first)) return star;
  const std::size_t most = mesh.triangles.size();

  // Clockwise to the boundary, or once around.
  std::int32_t start = first;
  for (std::size_t n = 0; n < most; ++n) {
    const Triangle& t = triangleAt(mesh, start);
    const int i = cornerOfVertex(t, vertex);
    if (i < 0) return star;
    const std::int32_t half = t.adj[static_cast<std::size_t>(prev3(i))];  // edge from the vertex to its next corner
    if (half < 0) break;
    start = triangleOf(half);
    if (start == first) break;
  }
  std::int32_t slot = start;
  for (std::size_t n = 0; n < most; ++n) {
    const Triangle& t = triangleAt(mesh, slot);
    const int i = cornerOfVertex(t, vertex);
    if (i < 0) return star;
    star.slots.push_back(slot);
    star.rim.push_back(t.v[static_cast<std::size_t>(next3(i))]);
    const std::int32_t half = t.adj[static_cast<std::size_t>(next3(i))];
    if (half < 0) {
      star.rim.push_back(t.v[static_cast<std::size_t>(prev3(i))]);
      return star;
    }
    slot = triangleOf(half);
    if (slot == start) {
      star.closed = true;
      return star;
    }
  }
  return star;
}

std::vector<std::array<std::int32_t, 2>> edgesBefore(const Mesh& mesh, const Star& star) {
  std::vector<std::array<std::int32_t, 2>> edges;
  const auto& rim = star.rim;
  if (rim.size() < 4) return edges;
  // The part of the rim from `from` to `to` closed by the edge between them; its third corner splits it in two.
  using Part = std::array<std::size_t, 2>;
  std::vector<Part> parts{{0, rim.size() - 1}};
  while (!parts.empty()) {
    const auto [from, to] = parts.back();
    parts.pop_back();
    const Point a = pointOf(mesh, rim[from]);
    const Point b = pointOf(mesh, rim[to]);
    std::size_t apex = to;
    for (std::size_t k = from + 1; k < to; ++k) {
      const Point p = pointOf(mesh, rim[k]);
      if (orient2d(a, p, b) <= 0) continue;
      if (apex == to || incircle(a, pointOf(mesh, rim[apex]), b, p) > 0) apex = k;
    }
    if (apex == to) continue;
    for (const Part part : {Part{from, apex}, Part{apex, to}}) {
      if (part[1] - part[0] < 2) continue;
      edges.push_back({rim[part[0]], rim[part[1]]});
      parts.push_back(part);
    }
  }
  return edges;
}

}  // namespace triscope
