// Moving a vertex with the Delaunay property restored by flips, and taking it back.
#pragma once

#include "core/mesh/edit.h"
#include "core/mesh/flip.h"

namespace triscope {

/// What a move changed, so that undoMove gives back the very same mesh, ids included.
struct MoveLog {
  struct Saved {
    Slot slot;
    Triangle triangle;
    TriangleId id;
    std::uint8_t flags;
    std::uint8_t tested;
  };
  struct SavedVertex {
    Vertex vertex;
    Slot triangle;
  };
  Vertex vertex;
  Point from;
  TriangleId nextId;
  std::vector<Saved> saved;  // in the order of change: undone backwards
  std::vector<SavedVertex> vertices;
  std::vector<Slot> slots;  // of the star and of every triangle flipped: the same region before and after
  std::uint32_t flips = 0;
  // Scratch of moveVertex().
  Star star;
  std::vector<Half> suspects;
};

/// Moves a vertex inside its closed star and flips until the region is Delaunay. Returns false, changing nothing, when
/// the star is open, or a triangle would turn over (exact).
bool moveVertex(Mesh& mesh, Vertex vertex, Point to, MoveLog& log);
void undoMove(Mesh& mesh, const MoveLog& log);

}  // namespace triscope
