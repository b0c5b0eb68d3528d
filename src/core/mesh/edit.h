// The elementary edits that every operation on the mesh is made of: births, deaths and links.
#pragma once

#include "core/mesh/mesh.h"

namespace triscope {

inline std::size_t at(std::int32_t index) { return static_cast<std::size_t>(index); }

/// A new vertex; no triangle uses it yet.
std::int32_t addVertex(Mesh& mesh, Point p, VertexKind kind, std::uint8_t density);
/// So many slots have half-edges that fit into 32 bits.
inline constexpr std::size_t kMostSlots = 0x7fffffff / 3;
/// The slot freed last, or a new one. It stays dead until a triangle is put there.
std::int32_t takeSlot(Mesh& mesh);
/// A triangle in a slot of its own, with a fresh id; its links are unset.
std::int32_t addTriangle(Mesh& mesh, std::int32_t a, std::int32_t b, std::int32_t c);
/// Frees the slot. Neighbours still point at it: the caller mends them.
void killTriangle(Mesh& mesh, std::int32_t slot);
/// Makes two half-edges each other's opposite; `other` may be -1.
inline void link(Mesh& mesh, std::int32_t half, std::int32_t other) {
  mesh.triangles[at(triangleOf(half))].adj[static_cast<std::size_t>(cornerOf(half))] = other;
  if (other >= 0) mesh.triangles[at(triangleOf(other))].adj[static_cast<std::size_t>(cornerOf(other))] = half;
}
inline void setConstrained(Mesh& mesh, std::int32_t half, bool on) {
  const auto bit = static_cast<std::uint8_t>(1u << cornerOf(half));
  auto& flags = mesh.flags[at(triangleOf(half))];
  flags = static_cast<std::uint8_t>(on ? flags | bit : flags & ~bit);
}

/// The half-edge from a to b, or -1 when the mesh has no such edge (either side is looked at; the returned one
/// runs a -> b, so at the boundary only the side in the domain is found).
std::int32_t findHalfEdge(const Mesh& mesh, std::int32_t a, std::int32_t b);

/// Half-edges on the rim of the star of a vertex, counter-clockwise. `closed` is false at the boundary, where the
/// first and last rim vertices are joined to the vertex by boundary edges.
struct Star {
  std::vector<std::int32_t> rim;  // half-edge opposite the vertex in each of its triangles
  bool closed = false;
};
void starOf(const Mesh& mesh, std::int32_t vertex, Star& star);

/// Boundary edges: each is in the lists of both its ends.
std::int32_t addBoundaryEdge(Mesh& mesh, const BoundaryEdge& edge);
std::int32_t findBoundaryEdge(const Mesh& mesh, std::int32_t a, std::int32_t b);
/// Edge (v0, v1) becomes (v0, middle); a new edge (middle, v1) takes the rest of the curve. Returns the new edge.
std::int32_t splitBoundaryEdge(Mesh& mesh, std::int32_t edge, std::int32_t middle, double t);

}  // namespace triscope
