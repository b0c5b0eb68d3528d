// The triangulation: flat arrays, triangles by index. Shape of a triangle t:
//
//            v[2]
//            /  \            edge i lies opposite v[i], from v[i+1] to v[i+2] (counter-clockwise);
//     edge 1/    \edge 0     adj[i] is the half-edge on the other side, 3·t' + k, or none at the boundary.
//          /      \          ...
//       v[0]------v[1]
//            edge 2
//
// Slots are reused; ids are not: id[slot] counts births, so "triangle 5821" is one triangle for good.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/point.h"
#include "core/mesh/ids.h"

namespace triscope {

enum class VertexKind : std::uint8_t {
  helper,    // corner of the box around everything; gone after carve
  kept,      // an input point or corner, never moved
  boundary,  // placed on a boundary curve by the density
  split,     // placed on a boundary curve by splitting an edge
  front1,
  front2,
  steiner,  // steps 1-5
  removed,  // no longer in the mesh; its index is never used again
};

struct Triangle {
  Corners<Vertex> v;
  Corners<Half> adj;
};

/// A piece of a boundary curve between two vertices, curve(t0) = point v0, curve(t1) = point v1.
struct BoundaryEdge {
  Vertex v0;
  Vertex v1;
  std::uint32_t curve = 0;
  EdgeId next0;  // next boundary edge in the list of v0, of v1
  EdgeId next1;
  double t0 = 0.0;
  double t1 = 1.0;
};

/// Bits of Mesh::flags.
inline constexpr std::uint8_t kConstrained0 = 1;  // edge i is on the boundary or an inner chain: 1 << i
inline constexpr std::uint8_t kDead = 8;          // free slot
inline constexpr std::uint8_t kFillsGap = 16;     // where repair took a vertex out: steps 1-5 would put it back
inline constexpr std::uint8_t kInCavity = 32;     // while one insertion looks at it; never left set
inline constexpr std::uint8_t kConstrainedAll = 7;
inline constexpr std::uint8_t kTestedAll = 255;  // Mesh::tested of a free slot: nothing to look at

struct Mesh {
  Per<Vertex, Point> points;
  Per<Vertex, VertexKind> kinds;
  Per<Vertex, std::uint8_t> density;  // rank where it was placed
  Per<Vertex, Slot> vertexTriangle;   // a live triangle around it, none when there is none
  Per<Vertex, EdgeId> vertexEdge;     // first boundary edge in its list, none when there is none
  Per<Slot, Triangle> triangles;
  Per<Slot, TriangleId> ids;
  Per<Slot, std::uint8_t> flags;
  Per<Slot, std::uint8_t> tested;  // bit k: rule k looked at it since it or a neighbour changed
  std::vector<Slot> freeSlots;     // last freed, first reused
  Per<EdgeId, BoundaryEdge> edges;
  TriangleId nextId{0};
  Slot lastTriangle{0};                      // where the next walk starts
  std::optional<std::vector<Slot>> touched;  // while a ChangeLog follows the edits: the slots they wrote to

  [[nodiscard]] bool alive(Slot slot) const { return (flags[slot] & kDead) == 0; }
  [[nodiscard]] std::size_t liveCount() const { return triangles.size() - freeSlots.size(); }
};

/// Corner after and before corner i of a triangle.
inline constexpr int next3(int i) { return i == 2 ? 0 : i + 1; }
inline constexpr int prev3(int i) { return i == 0 ? 2 : i - 1; }

/// Half-edge 3·t + i is edge i of triangle t, from its start to its end.
inline constexpr Half halfOf(Slot slot, int corner) { return Half(3 * slot.n + corner); }
inline constexpr Slot triangleOf(Half half) { return Slot(half.n / 3); }
inline constexpr int cornerOf(Half half) { return half.n % 3; }
/// Of all slots, also the free ones.
inline Keys<Half> halvesOf(const Mesh& mesh) { return {Half(0), Half(3 * mesh.triangles.size())}; }
inline constexpr Keys<Half> halvesOf(Slot slot) { return {halfOf(slot, 0), Half(3 * slot.n + 3)}; }
/// Corner of a triangle that a vertex of it is at.
inline constexpr int cornerOf(const Triangle& triangle, Vertex vertex) {
  return triangle.v[0] == vertex ? 0 : triangle.v[1] == vertex ? 1 : 2;
}
inline const Triangle& triangleAt(const Mesh& mesh, Slot slot) { return mesh.triangles[slot]; }
inline Point pointOf(const Mesh& mesh, Vertex vertex) { return mesh.points[vertex]; }
inline Vertex startOf(const Mesh& mesh, Half half) {
  return triangleAt(mesh, triangleOf(half)).v[next3(cornerOf(half))];
}
inline Vertex endOf(const Mesh& mesh, Half half) { return triangleAt(mesh, triangleOf(half)).v[prev3(cornerOf(half))]; }
inline Vertex apexOf(const Mesh& mesh, Half half) { return triangleAt(mesh, triangleOf(half)).v[cornerOf(half)]; }
inline Half oppositeOf(const Mesh& mesh, Half half) { return triangleAt(mesh, triangleOf(half)).adj[cornerOf(half)]; }
/// Twice the area of a triangle, positive when it is counter-clockwise.
inline double twiceArea(const Mesh& mesh, Slot slot) {
  const Triangle& t = triangleAt(mesh, slot);
  const Point a = pointOf(mesh, t.v[0]);
  return cross(pointOf(mesh, t.v[1]) - a, pointOf(mesh, t.v[2]) - a);
}
/// Whether a corner of a live triangle belongs to the box around everything.
inline bool touchesHelper(const Mesh& mesh, Slot slot) {
  for (const Vertex v : triangleAt(mesh, slot).v)
    if (mesh.kinds[v] == VertexKind::helper) return true;
  return false;
}
inline bool constrained(const Mesh& mesh, Half half) {
  return (mesh.flags[triangleOf(half)] >> cornerOf(half) & 1) != 0;
}
inline TriangleId idOf(const Mesh& mesh, Slot slot) { return mesh.ids[slot]; }
/// Slot of the live triangle with this id, none when there is none. Looks at every slot.
inline Slot slotOf(const Mesh& mesh, TriangleId id) {
  for (const Slot slot : mesh.triangles.keys())
    if (mesh.ids[slot] == id && mesh.alive(slot)) return slot;
  return {};
}

}  // namespace triscope
