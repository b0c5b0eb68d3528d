// Bowyer-Watson insertion in two halves: find the cavity (changes nothing), then fill it.
#pragma once

#include <span>

#include "core/mesh/mesh.h"

namespace triscope {

/// The connected triangles whose circumcircle holds a point, not reaching through constrained edges, and the room that
/// it takes to find and to fill them. Nothing is carried over from one cavity to the next but that room: a caller that
/// keeps the object allocates nothing.
struct Cavity {
  /// An edge of the rim, counter-clockwise around the point: from its vertex to that of the next one.
  struct RimEdge {
    Vertex vertex;
    std::int32_t across;  // half-edge on the other side; -2 - (half-edge on this side) of one not to be crossed
    [[nodiscard]] bool isWall() const { return across < 0; }
    [[nodiscard]] Half wall() const { return Half(-2 - across); }
  };
  /// A vertex as the point sees it.
  struct Sight {
    double x, y, squaredDistance;
    Vertex vertex;
  };
  /// An edge of a triangle of the cavity that was not looked across yet; ends by their places in `sights`.
  struct Open {
    std::int32_t from, to;
    std::int32_t across;  // as in RimEdge
    double area;          // twice that of the triangle from it to the point
  };

  Point at;
  double nearest = 0.0;  // shortest squared distance to a vertex: on the rim of a cavity, all of them are
  bool walled = false;   // some edge of the rim is not to be crossed
  std::size_t triangleCount = 0;
  std::size_t rimCount = 0;
  std::size_t sightCount = 0;
  std::size_t capacity = 0;    // triangles that there is room for; doubled when it is used up
  std::vector<Slot> slots;     // in [capacity - triangleCount, capacity): last found first; the fan's others behind
  std::vector<RimEdge> edges;  // the rim, and behind it where it ends
  std::vector<Sight> sights;
  std::vector<Open> open;

  /// Last found first: the search began at the last one.
  [[nodiscard]] std::span<const Slot> triangles() const { return {firstSlot(), triangleCount}; }
  [[nodiscard]] std::span<const RimEdge> rim() const { return {edges.data(), rimCount}; }
  /// The new triangles along the rim, once it is filled: in the slots of those that gave way, as if these had been
  /// freed one by one, and then in one or two others.
  [[nodiscard]] std::span<const Slot> fan() const { return {firstSlot(), rimCount}; }
  [[nodiscard]] const Slot* firstSlot() const { return slots.data() + (capacity - triangleCount); }
  /// Whether the rim runs all the way round: not that of a point on the boundary.
  [[nodiscard]] bool closed() const { return edges[rimCount].vertex == edges[0].vertex; }
};

/// The half-edge of a cavity's triangle along an edge of its rim, before it is filled.
Half halfEdgeOf(const Mesh& mesh, const Cavity::RimEdge& edge);

/// Begins at `start`, which must hold p in its closure or in its circumcircle.
void findCavity(Mesh& mesh, Point p, Slot start, Cavity& cavity);

/// Same, for a point that splits the constrained half-edge `edge`: the rim leaves out that edge, on both sides when
/// the edge is an inner one. Returns false, with an empty cavity, when p does not see the whole rim.
bool findSplitCavity(Mesh& mesh, Point p, Half edge, Cavity& cavity);

/// Replaces the cavity by triangles from its rim to a new vertex. The new triangles have consecutive ids.
Vertex fillCavity(Mesh& mesh, Cavity& cavity, VertexKind kind, std::uint8_t density);

/// Same for the cavity of a split: boundary edge `edge` of Mesh::edges is split at curve parameter t.
Vertex fillSplitCavity(Mesh& mesh, Cavity& cavity, EdgeId edge, double t, std::uint8_t density);

}  // namespace triscope
