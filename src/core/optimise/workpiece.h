// What the optimiser works on, and the room that it needs to.
#pragma once

#include <span>
#include <vector>

#include "core/domain/curve.h"
#include "core/mesh/edit_log.h"
#include "core/mesh/flip.h"
#include "core/optimise/ring.h"

namespace triscope {

/// Per vertex, how many triangles it has beyond those that suit it best; see excessOf().
using Excess = Per<Vertex, std::int8_t>;

/// An edge, however the triangles around it come to lie: the lower vertex first.
struct EdgeEnds {
  Vertex a, b;
  friend bool operator==(const EdgeEnds&, const EdgeEnds&) = default;
};
inline EdgeEnds endsOf(Vertex a, Vertex b) { return a < b ? EdgeEnds{a, b} : EdgeEnds{b, a}; }

/// Numbers that were seen in the same search have its mark.
template <class Key>
class Marks {
 public:
  void begin(std::size_t count) {
    marks_.resize(count, 0);
    ++mark_;
  }
  /// True the first time.
  bool take(Key key) {
    if (marks_[key] == mark_) return false;
    marks_[key] = mark_;
    return true;
  }
  [[nodiscard]] bool has(Key key) const { return marks_.has(key) && marks_[key] == mark_; }
  void forget(Key key) { marks_[key] = 0; }

 private:
  Per<Key, std::uint32_t> marks_;
  std::uint32_t mark_ = 0;
};

/// Nothing in it means anything from one decision to the next.
struct OptimiserRoom {
  EditLog log;
  Ring ring;
  std::vector<Half> suspects;
  std::vector<Vertex> patch;    // vertices around what is worked at, nearest first
  std::vector<Vertex> touched;  // by an edit
  std::vector<Vertex> queue, nextQueue;
  Marks<Vertex> seen, inPatch, queued;
  Marks<Slot> seenSlots;
};

/// The mesh, the edge length wanted at each vertex, and the boundary's curves.
struct Workpiece {
  Mesh& mesh;
  Sizes& sizes;
  const std::vector<Curve>& curves;
  OptimiserRoom& room;
};

/// Vertices within `depth` edges of the seeds, nearest first. Returns how many of them are within one edge less.
std::size_t verticesAround(Workpiece& work, std::span<const Vertex> seeds, int depth, std::vector<Vertex>& found);

/// Says of all triangles of a star that a corner of theirs has moved.
void noteRing(Mesh& mesh, const Ring& ring);
/// All edges of the star, and of its rim, are suspected not to be Delaunay.
void suspectStar(Workpiece& work, Vertex vertex);

/// Calls visit(slot) once for each triangle that has one of the vertices.
template <class Visit>
void forEachTriangleAround(Workpiece& work, std::span<const Vertex> vertices, const Visit& visit) {
  Ring& ring = work.room.ring;
  work.room.seenSlots.begin(work.mesh.triangles.size());
  for (const Vertex v : vertices) {
    if (!gatherLinks(work.mesh, v, ring)) continue;
    for (const Half rim : ring.rims())
      if (work.room.seenSlots.take(triangleOf(rim))) visit(triangleOf(rim));
  }
}

/// Flips until the suspects, and what comes of them, are Delaunay. `flipping(half)` is told of each edge before. All
/// triangles are counter-clockwise. Returns how many flips that took.
template <class Flipping>
std::size_t flipSuspects(Workpiece& work, const Flipping& flipping) {
  std::size_t flips = 0;
  flipWhileWanted(work.mesh, work.room.suspects, [&](Half half) {
    flipping(half);
    ++flips;
    return flipEdge(work.mesh, half, work.room.log);
  });
  work.room.suspects.clear();
  return flips;
}
inline std::size_t flipSuspects(Workpiece& work) {
  return flipSuspects(work, [](Half) {});
}

}  // namespace triscope
