#include "core/mesh/move.h"

#include <algorithm>

#include "core/geometry/predicates.h"
#include "core/mesh/change_log.h"
#include "core/mesh/edit.h"

namespace triscope {
namespace {

void save(const Mesh& mesh, std::int32_t slot, MoveLog& log) {
  log.saved.push_back({slot, triangleAt(mesh, slot), idOf(mesh, slot), mesh.flags[at(slot)], mesh.tested[at(slot)]});
}

void saveFlip(const Mesh& mesh, std::int32_t half, MoveLog& log) {
  const std::int32_t left = triangleOf(half);
  const std::int32_t right = triangleOf(oppositeOf(mesh, half));
  for (const std::int32_t slot : {left, right}) {
    save(mesh, slot, log);
    for (const std::int32_t across : triangleAt(mesh, slot).adj) {
      if (across >= 0 && triangleOf(across) != left && triangleOf(across) != right) save(mesh, triangleOf(across), log);
    }
    for (const std::int32_t v : triangleAt(mesh, slot).v) log.vertices.push_back({v, mesh.vertexTriangle[at(v)]});
    if (std::find(log.slots.begin(), log.slots.end(), slot) == log.slots.end()) log.slots.push_back(slot);
  }
  ++log.flips;
}

}  // namespace

bool moveVertex(Mesh& mesh, std::int32_t vertex, Point to, MoveLog& log) {
  Star& star = log.star;
  std::vector<std::int32_t>& suspects = log.suspects;
  starOf(mesh, vertex, star);
  if (!star.closed) return false;
  for (const std::int32_t rim : star.rim) {
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
  for (const std::int32_t rim : star.rim) {
    const std::int32_t slot = triangleOf(rim);
    save(mesh, slot, log);
    log.slots.push_back(slot);
    noteTouched(mesh, slot);
    suspects.push_back(rim);
    suspects.push_back(3 * slot + next3(cornerOf(rim)));
  }
  mesh.points[at(vertex)] = to;
  const std::size_t most = mostFlips(mesh);
  while (!suspects.empty()) {
    const std::int32_t half = suspects.back();
    suspects.pop_back();
    if (!flipWanted(mesh, half)) continue;
    if (log.flips == most) {
      undoMove(mesh, log);
      return false;
    }
    saveFlip(mesh, half, log);
    const std::int32_t diagonal = flipEdge(mesh, half);
    const std::int32_t other = oppositeOf(mesh, diagonal);
    for (const std::int32_t side : {diagonal, other}) {
      suspects.push_back(3 * triangleOf(side) + next3(cornerOf(side)));
      suspects.push_back(3 * triangleOf(side) + prev3(cornerOf(side)));
    }
  }
  for (const std::int32_t slot : log.slots) {
    mesh.tested[at(slot)] = 0;
    for (const std::int32_t across : triangleAt(mesh, slot).adj) {
      if (across < 0) continue;
      const std::int32_t neighbour = triangleOf(across);
      if (mesh.tested[at(neighbour)] != 0) {
        save(mesh, neighbour, log);
        mesh.tested[at(neighbour)] = 0;
      }
    }
  }
  return true;
}

void undoMove(Mesh& mesh, const MoveLog& log) {
  for (auto saved = log.saved.rbegin(); saved != log.saved.rend(); ++saved) {
    mesh.triangles[at(saved->slot)] = saved->triangle;
    mesh.ids[at(saved->slot)] = saved->id;
    mesh.flags[at(saved->slot)] = saved->flags;
    mesh.tested[at(saved->slot)] = saved->tested;
  }
  for (auto saved = log.vertices.rbegin(); saved != log.vertices.rend(); ++saved) {
    mesh.vertexTriangle[at(saved->vertex)] = saved->triangle;
  }
  mesh.points[at(log.vertex)] = log.from;
  mesh.nextId = log.nextId;
}

}  // namespace triscope
