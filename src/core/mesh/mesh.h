// The triangulation: flat arrays, triangles by index. Shape of a triangle t:
//
//            v[2]
//            /  \            edge i lies opposite v[i], from v[i+1] to v[i+2] (counter-clockwise);
//     edge 1/    \edge 0     adj[i] is the half-edge on the other side, 3·t' + k, or -1 at the boundary.
//          /      \          ...
//       v[0]------v[1]
//            edge 2
//
// Slots are reused; ids are not: id[slot] counts births, so "triangle 5821" is one triangle for good.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/point.h"

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
  std::array<std::int32_t, 3> v{-1, -1, -1};
  std::array<std::int32_t, 3> adj{-1, -1, -1};
};

/// A piece of a boundary curve between two vertices, curve(t0) = point v0, curve(t1) = point v1.
struct BoundaryEdge {
  std::int32_t v0 = -1;
  std::int32_t v1 = -1;
  std::uint32_t curve = 0;
  std::int32_t next0 = -1;  // next boundary edge in the list of v0, of v1
  std::int32_t next1 = -1;
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
  std::vector<Point> points;
  std::vector<VertexKind> kinds;             // per vertex
  std::vector<std::uint8_t> density;         // per vertex: density rank where it was placed
  std::vector<std::int32_t> vertexTriangle;  // per vertex: a live triangle around it, -1 when none
  std::vector<std::int32_t> vertexEdge;      // per vertex: first boundary edge in its list, -1 when none
  std::vector<Triangle> triangles;           // per slot
  std::vector<std::uint32_t> ids;            // per slot
  std::vector<std::uint8_t> flags;           // per slot
  std::vector<std::uint8_t> tested;          // per slot: bit k: rule k looked at it since it or a neighbour changed
  std::vector<std::int32_t> freeSlots;       // last freed, first reused
  std::vector<BoundaryEdge> edges;
  std::uint32_t nextId = 0;
  std::int32_t lastTriangle = 0;                     // where the next walk starts
  std::optional<std::vector<std::int32_t>> touched;  // while a ChangeLog follows the edits: the slots they wrote to

  [[nodiscard]] bool alive(std::int32_t slot) const { return (flags[static_cast<std::size_t>(slot)] & kDead) == 0; }
  [[nodiscard]] std::size_t liveCount() const { return triangles.size() - freeSlots.size(); }
};

/// Corner after and before corner i of a triangle.
inline constexpr int next3(int i) { return i == 2 ? 0 : i + 1; }
inline constexpr int prev3(int i) { return i == 0 ? 2 : i - 1; }

/// Half-edge h = 3·t + i is edge i of triangle t, from its start to its end.
inline constexpr std::int32_t triangleOf(std::int32_t half) { return half / 3; }
inline constexpr int cornerOf(std::int32_t half) { return half % 3; }
inline const Triangle& triangleAt(const Mesh& mesh, std::int32_t slot) {
  return mesh.triangles[static_cast<std::size_t>(slot)];
}
inline Point pointOf(const Mesh& mesh, std::int32_t vertex) { return mesh.points[static_cast<std::size_t>(vertex)]; }
inline std::int32_t startOf(const Mesh& mesh, std::int32_t half) {
  return triangleAt(mesh, triangleOf(half)).v[static_cast<std::size_t>(next3(cornerOf(half)))];
}
inline std::int32_t endOf(const Mesh& mesh, std::int32_t half) {
  return triangleAt(mesh, triangleOf(half)).v[static_cast<std::size_t>(prev3(cornerOf(half)))];
}
inline std::int32_t apexOf(const Mesh& mesh, std::int32_t half) {
  return triangleAt(mesh, triangleOf(half)).v[static_cast<std::size_t>(cornerOf(half))];
}
inline std::int32_t oppositeOf(const Mesh& mesh, std::int32_t half) {
  return triangleAt(mesh, triangleOf(half)).adj[static_cast<std::size_t>(cornerOf(half))];
}
/// Twice the area of a triangle, positive when it is counter-clockwise.
inline double twiceArea(const Mesh& mesh, std::int32_t slot) {
  const Triangle& t = triangleAt(mesh, slot);
  const Point a = pointOf(mesh, t.v[0]);
  return cross(pointOf(mesh, t.v[1]) - a, pointOf(mesh, t.v[2]) - a);
}
/// Whether a corner of a live triangle belongs to the box around everything.
inline bool touchesHelper(const Mesh& mesh, std::int32_t slot) {
  for (const std::int32_t v : triangleAt(mesh, slot).v)
    if (mesh.kinds[static_cast<std::size_t>(v)] == VertexKind::helper) return true;
  return false;
}
inline bool constrained(const Mesh& mesh, std::int32_t half) {
  return (mesh.flags[static_cast<std::size_t>(triangleOf(half))] >> cornerOf(half) & 1) != 0;
}
inline std::uint32_t idOf(const Mesh& mesh, std::int32_t slot) { return mesh.ids[static_cast<std::size_t>(slot)]; }
/// Slot of the live triangle with this id, -1 when there is none. Looks at every slot.
inline std::int32_t slotOf(const Mesh& mesh, std::uint32_t id) {
  for (std::size_t slot = 0; slot < mesh.ids.size(); ++slot) {
    if (mesh.ids[slot] == id && (mesh.flags[slot] & kDead) == 0) return static_cast<std::int32_t>(slot);
  }
  return -1;
}

}  // namespace triscope
