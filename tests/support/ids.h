// Numbers of a mesh's things, short to write in tests: 3_v is vertex 3. And for what tests say when they fail.
#pragma once

#include <ostream>

#include "core/mesh/mesh.h"

namespace triscope {

template <class Kind, class Word>
std::ostream& operator<<(std::ostream& out, Index<Kind, Word> index) {
  return out << index.n;
}

namespace support {

constexpr Vertex operator""_v(unsigned long long n) { return Vertex(n); }
constexpr Slot operator""_slot(unsigned long long n) { return Slot(n); }
constexpr Half operator""_half(unsigned long long n) { return Half(n); }
constexpr EdgeId operator""_edge(unsigned long long n) { return EdgeId(n); }
constexpr TriangleId operator""_id(unsigned long long n) { return TriangleId(n); }

/// Boundary edge from a to b.
inline BoundaryEdge boundaryEdge(Vertex a, Vertex b, std::uint32_t curve = 0) {
  BoundaryEdge edge;
  edge.v0 = a;
  edge.v1 = b;
  edge.curve = curve;
  return edge;
}

}  // namespace support
}  // namespace triscope
