#include "core/mesh/move.h"

#include <algorithm>

#include "core/geometry/predicates.h"
#include "core/mesh/change_log.h"
#include "core/mesh/edit.h"

namespace triscope {
namespace {

void save(const Mesh& mesh, Slot slot, MoveLog& log) {
  log.saved.push_back({slot, triangleAt(mesh, slot), idOf(mesh, slot), mesh.flags[slot], mesh.tested[slot]});
}

void saveFlip(const Mesh& mesh, Half half, MoveLog& log) {
  const Slot left = triangleOf(half);
  const Slot right = triangleOf(oppositeOf(mesh, half));
  for (const Slot slot : {left, right}) {
    save(mesh, slot, log);
    for (const Half across : triangleAt(mesh, slot).adj) {
      if (across.exists() && triangleOf(across) != left && triangleOf(across) != right)
        save(mesh, triangleOf(across), log);
    }
    for (const Vertex v : triangleAt(mesh, slot).v) log.vertices.push_back({v, mesh.vertexTriangle[v]});
    if (std::find(log.slots.begin(), log.slots.end(), slot) == log.slots.end()) log.slots.push_back(slot);
  }
  ++log.flips;
}

}  // namespace

bool moveVertex(Mesh& mesh, Vertex vertex, Point to, MoveLog& log) {
  Star& star = log.star;
  std::vector<Half>& suspects = log.suspects;
  starOf(mesh, vertex, star);
  if (!star.closed) return false;
  for (const Half rim : star.rim) {
    if (orient2d(pointOf(mesh, startOf(mesh, rim)), pointOf(mesh, endOf(mesh, rim)), to) <= 0) return false;
  }
  log.vertex = vertex;
  log.from = pointOf(mesh, vertex);
  log.nextId = mesh.nextId;
  log.saved.clear();
  log.vertices.clear();
  log.slots.clear();
  log.flips = 0;
  suspects.clear();
  for (const Half rim : star.rim) {
    const Slot slot = triangleOf(rim);
    save(mesh, slot, log);
    log.slots.push_back(slot);
    noteTouched(mesh, slot);
    suspects.push_back(rim);
    suspects.push_back(halfOf(slot, next3(cornerOf(rim))));
  }
  mesh.points[vertex] = to;
  const std::size_t most = mostFlips(mesh);
  while (!suspects.empty()) {
    const Half half = suspects.back();
    suspects.pop_back();
    if (!flipWanted(mesh, half)) continue;
    if (log.flips == most) {
      undoMove(mesh, log);
      return false;
    }
    saveFlip(mesh, half, log);
    const Half diagonal = flipEdge(mesh, half);
    const Half other = oppositeOf(mesh, diagonal);
    for (const Half side : {diagonal, other}) {
      suspects.push_back(halfOf(triangleOf(side), next3(cornerOf(side))));
      suspects.push_back(halfOf(triangleOf(side), prev3(cornerOf(side))));
    }
  }
  for (const Slot slot : log.slots) {
    mesh.tested[slot] = 0;
    for (const Half across : triangleAt(mesh, slot).adj) {
      if (!across.exists()) continue;
      const Slot neighbour = triangleOf(across);
      if (mesh.tested[neighbour] != 0) {
        save(mesh, neighbour, log);
        mesh.tested[neighbour] = 0;
      }
    }
  }
  return true;
}

void undoMove(Mesh& mesh, const MoveLog& log) {
  for (auto saved = log.saved.rbegin(); saved != log.saved.rend(); ++saved) {
    mesh.triangles[saved->slot] = saved->triangle;
    mesh.ids[saved->slot] = saved->id;
    mesh.flags[saved->slot] = saved->flags;
    mesh.tested[saved->slot] = saved->tested;
  }
  for (auto saved = log.vertices.rbegin(); saved != log.vertices.rend(); ++saved) {
    mesh.vertexTriangle[saved->vertex] = saved->triangle;
  }
  mesh.points[log.vertex] = log.from;
  mesh.nextId = log.nextId;
}

}  // namespace triscope
