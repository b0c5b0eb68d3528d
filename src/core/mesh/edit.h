// The elementary edits that every operation on the mesh is made of: births, deaths and links.
#pragma once

#include "core/mesh/mesh.h"

namespace triscope {

/// A new vertex; no triangle uses it yet.
Vertex addVertex(Mesh& mesh, Point p, VertexKind kind, std::uint8_t density);
/// So many slots have half-edges that fit into 32 bits.
inline constexpr std::size_t kMostSlots = 0x7fffffff / 3;
/// The slot freed last, or a new one. It stays dead until a triangle is put there.
Slot takeSlot(Mesh& mesh);
/// A triangle in a slot of its own, with a fresh id; its links are unset.
Slot addTriangle(Mesh& mesh, Vertex a, Vertex b, Vertex c);
/// Frees the slot. Neighbours still point at it: the caller mends them.
void killTriangle(Mesh& mesh, Slot slot);
/// Makes two half-edges each other's opposite; `other` may be none.
inline void link(Mesh& mesh, Half half, Half other) {
  mesh.triangles[triangleOf(half)].adj[cornerOf(half)] = other;
  if (other.exists()) mesh.triangles[triangleOf(other)].adj[cornerOf(other)] = half;
}
/// Makes this side of an edge one that is not to be crossed or flipped.
inline void constrain(Mesh& mesh, Half half) {
  mesh.flags[triangleOf(half)] |= static_cast<std::uint8_t>(1u << cornerOf(half));
}

/// The half-edge from a to b, or none when the mesh has no such edge (either side is looked at; the returned one
/// runs a -> b, so at the boundary only the side in the domain is found).
Half findHalfEdge(const Mesh& mesh, Vertex a, Vertex b);
/// The same, or the one from b to a where the mesh has only that: one side of the edge wherever there is an edge.
Half edgeBetween(const Mesh& mesh, Vertex a, Vertex b);

/// Half-edges on the rim of the star of a vertex, counter-clockwise. `closed` is false at the boundary, where the
/// first and last rim vertices are joined to the vertex by boundary edges.
struct Star {
  std::vector<Half> rim;  // half-edge opposite the vertex in each of its triangles
  bool closed = false;
};
void starOf(const Mesh& mesh, Vertex vertex, Star& star);
/// The triangle that it begins with: clockwise of it the star ends, or it is Mesh::vertexTriangle and the star is
/// closed.
Slot firstInStar(const Mesh& mesh, Vertex vertex);

/// Boundary edges: each is in the lists of both its ends. One that was merged into another has no ends any more.
inline bool exists(const BoundaryEdge& edge) { return edge.v0.exists(); }
/// The one after `edge` in the list of its end `vertex`.
inline EdgeId nextEdgeAt(const Mesh& mesh, EdgeId edge, Vertex vertex) {
  const BoundaryEdge& e = mesh.edges[edge];
  return e.v0 == vertex ? e.next0 : e.next1;
}
EdgeId addBoundaryEdge(Mesh& mesh, const BoundaryEdge& edge);
EdgeId findBoundaryEdge(const Mesh& mesh, Vertex a, Vertex b);
/// Edge (v0, v1) becomes (v0, middle); a new edge (middle, v1) takes the rest of the curve. Returns the new edge.
EdgeId splitBoundaryEdge(Mesh& mesh, EdgeId edge, Vertex middle, double t);

}  // namespace triscope
