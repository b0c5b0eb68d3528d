// Moving a vertex with the Delaunay property restored by flips, and taking it back.
#pragma once

#include "core/mesh/edit.h"
#include "core/mesh/edit_log.h"
#include "core/mesh/flip.h"

namespace triscope {

/// What a move changed.
struct MoveLog {
  EditLog edits;
  EditMark before;
  std::vector<Slot> slots;  // of the star and of every triangle flipped: the same region before and after
  std::uint32_t flips = 0;
  // Scratch of moveVertex().
  Star star;
  std::vector<Half> suspects;
};

/// Moves a vertex inside its closed star and flips until the region is Delaunay. Returns false, changing nothing, when
/// the star is open, or a triangle would turn over (exact).
bool moveVertex(Mesh& mesh, Vertex vertex, Point to, MoveLog& log);
/// Gives back the very same mesh, ids included.
void undoMove(Mesh& mesh, MoveLog& log);

}  // namespace triscope
