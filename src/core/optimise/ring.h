// The star of a vertex with the edge lengths in force around it, gathered once: what every move of the optimiser reads.
#pragma once

#include <array>
#include <span>

#include "core/mesh/mesh.h"

namespace triscope {

/// Edge length that is wanted at each vertex.
using Sizes = Per<Vertex, double>;

struct Ring {
  static constexpr int kMost = 64;  // triangles

  int count = 0;  // of triangles
  bool closed = false;
  std::array<Half, kMost> rim;  // opposite the hub in each triangle, counter-clockwise
  // Where each rim edge begins, and one more: where the last ends, which is the first again when the star is closed.
  std::array<Vertex, kMost + 1> vertices;
  std::array<Point, kMost + 1> at;
  std::array<double, kMost + 1> sizes;

  [[nodiscard]] std::span<const Half> rims() const { return {rim.data(), static_cast<std::size_t>(count)}; }
  /// Of the hub, each once.
  [[nodiscard]] std::span<const Vertex> neighbours() const {
    return {vertices.data(), static_cast<std::size_t>(closed ? count : count + 1)};
  }
};

/// False for a vertex that no triangle uses, or more than kMost do. Only the vertices and half-edges.
bool gatherLinks(const Mesh& mesh, Vertex hub, Ring& ring);
/// With places and sizes.
bool gatherRing(const Mesh& mesh, const Sizes& sizes, Vertex hub, Ring& ring);

/// Twice the area of the triangle over rim edge k with the hub at p.
inline double fanArea(const Ring& ring, int k, Point p) {
  const auto i = static_cast<std::size_t>(k);
  return cross(ring.at[i] - p, ring.at[i + 1] - p);
}

}  // namespace triscope
