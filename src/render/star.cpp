#include "render/star.h"

#include "core/geometry/predicates.h"

namespace triscope {
std::vector<Slot> slotsOf(const Star& star) {
  std::vector<Slot> slots;
  slots.reserve(star.rim.size());
  for (const Half half : star.rim) slots.push_back(triangleOf(half));
  return slots;
}

std::vector<Vertex> rimVertices(const Mesh& mesh, const Star& star) {
  std::vector<Vertex> rim;
  rim.reserve(star.rim.size() + 1);
  for (const Half half : star.rim) rim.push_back(startOf(mesh, half));
  if (!star.closed && !star.rim.empty()) rim.push_back(endOf(mesh, star.rim.back()));
  return rim;
}

std::vector<std::array<Vertex, 2>> edgesBefore(const Mesh& mesh, const std::vector<Vertex>& rim) {
  std::vector<std::array<Vertex, 2>> edges;
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
