// What the things of a mesh are counted by.
#pragma once

#include "core/base/index.h"

namespace triscope {

/// A vertex: its place in the arrays of vertices of a Mesh. Never used again once the vertex is gone.
using Vertex = Index<struct VertexName>;
/// A place for a triangle in the arrays of triangles; used again when the triangle is gone.
using Slot = Index<struct SlotName>;
/// One side of an edge: edge i of the triangle in slot t is half-edge 3·t + i.
using Half = Index<struct HalfName>;
/// A triangle for good: births are counted.
using TriangleId = Index<struct TriangleName, std::uint32_t>;
/// A piece of the boundary: its place in Mesh::edges.
using EdgeId = Index<struct EdgeName>;

/// A value for each corner of a triangle, or for each edge by the corner opposite.
template <class Value>
struct Corners {
  Value at[3];

  template <std::integral Corner>
  [[nodiscard]] constexpr Value& operator[](Corner corner) {
    return at[corner];
  }
  template <std::integral Corner>
  [[nodiscard]] constexpr const Value& operator[](Corner corner) const {
    return at[corner];
  }
  [[nodiscard]] constexpr const Value* begin() const { return at; }
  [[nodiscard]] constexpr const Value* end() const { return at + 3; }
  friend bool operator==(const Corners&, const Corners&) = default;
};

}  // namespace triscope
