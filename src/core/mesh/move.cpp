#include "core/mesh/move.h"

#include <algorithm>

#include "core/geometry/predicates.h"
#include "core/mesh/change_log.h"
#include "core/mesh/edit.h"

namespace triscope {

bool moveVertex(Mesh& mesh, Vertex vertex, Point to, MoveLog& log) {
  Star& star = log.star;
  std::vector<Half>& suspects = log.suspects;
  starOf(mesh, vertex, star);
  if (!star.closed) return false;
  for (const Half rim : star.rim) {
    if (orient2d(pointOf(mesh, startOf(mesh, rim)), pointOf(mesh, endOf(mesh, rim)), to) <= 0) return false;
  }
  beginEdits(log.edits);
  log.before = markOf(mesh, log.edits);
  log.slots.clear();
  log.flips = 0;
  suspects.clear();
  for (const Half rim : star.rim) {
    const Slot slot = triangleOf(rim);
    save(mesh, slot, log.edits);
    log.slots.push_back(slot);
    noteTouched(mesh, slot);
    suspects.push_back(rim);
    suspects.push_back(halfOf(slot, next3(cornerOf(rim))));
  }
  movePoint(mesh, vertex, to, log.edits);
  const bool delaunay = flipWhileWanted(mesh, suspects, [&](Half half) {
    const Half diagonal = flipEdge(mesh, half, log.edits);
    ++log.flips;
    for (const Half side : {diagonal, oppositeOf(mesh, diagonal)}) {
      const Slot slot = triangleOf(side);
      if (std::find(log.slots.begin(), log.slots.end(), slot) == log.slots.end()) log.slots.push_back(slot);
    }
    return diagonal;
  });
  if (!delaunay) {
    undoMove(mesh, log);
    return false;
  }
  for (const Slot slot : log.slots) {
    mesh.tested[slot] = 0;
    for (const Half across : triangleAt(mesh, slot).adj) {
      if (!across.exists()) continue;
      const Slot neighbour = triangleOf(across);
      if (mesh.tested[neighbour] != 0) {
        save(mesh, neighbour, log.edits);
        mesh.tested[neighbour] = 0;
      }
    }
  }
  return true;
}

void undoMove(Mesh& mesh, MoveLog& log) { undoEdits(mesh, log.edits, log.before); }

}  // namespace triscope
