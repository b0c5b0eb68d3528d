#include "core/mesh/edit_log.h"

#include "core/mesh/edit.h"
#include "core/mesh/flip.h"

namespace triscope {

void beginEdits(EditLog& log) {
  log.slots.clear();
  log.vertices.clear();
  log.edges.clear();
  log.free.clear();
}

EditMark markOf(const Mesh& mesh, const EditLog& log) {
  return {log.slots.size(),      log.vertices.size(), log.edges.size(),  log.free.size(),
          mesh.triangles.size(), mesh.points.size(),  mesh.edges.size(), mesh.nextId};
}

void undoEdits(Mesh& mesh, EditLog& log, const EditMark& mark) {
  for (std::size_t k = log.slots.size(); k-- > mark.slots;) {
    const EditLog::SavedSlot& saved = log.slots[k];
    mesh.triangles[saved.slot] = saved.triangle;
    mesh.ids[saved.slot] = saved.id;
    mesh.flags[saved.slot] = saved.flags;
    mesh.tested[saved.slot] = saved.tested;
  }
  for (std::size_t k = log.vertices.size(); k-- > mark.vertices;) {
    const EditLog::SavedVertex& saved = log.vertices[k];
    mesh.points[saved.vertex] = saved.at;
    mesh.kinds[saved.vertex] = saved.kind;
    mesh.vertexTriangle[saved.vertex] = saved.triangle;
    mesh.vertexEdge[saved.vertex] = saved.edge;
  }
  for (std::size_t k = log.edges.size(); k-- > mark.edges;) mesh.edges[log.edges[k].edge] = log.edges[k].was;
  for (std::size_t k = log.free.size(); k-- > mark.free;) {
    if (log.free[k].exists())
      mesh.freeSlots.push_back(log.free[k]);
    else
      mesh.freeSlots.pop_back();
  }
  // Who follows the edits has not seen slots that came and went.
  if (mesh.touched && mesh.triangles.size() > mark.allSlots)
    std::erase_if(*mesh.touched, [&](Slot slot) { return slot >= Slot(mark.allSlots); });
  mesh.triangles.resize(mark.allSlots);
  mesh.ids.resize(mark.allSlots);
  mesh.flags.resize(mark.allSlots);
  mesh.tested.resize(mark.allSlots);
  mesh.points.resize(mark.allVertices);
  mesh.kinds.resize(mark.allVertices);
  mesh.density.resize(mark.allVertices);
  mesh.vertexTriangle.resize(mark.allVertices);
  mesh.vertexEdge.resize(mark.allVertices);
  mesh.edges.resize(mark.allEdges);
  mesh.nextId = mark.nextId;
  log.slots.resize(mark.slots);
  log.vertices.resize(mark.vertices);
  log.edges.resize(mark.edges);
  log.free.resize(mark.free);
}

void save(const Mesh& mesh, Slot slot, EditLog& log) {
  log.slots.push_back({slot, triangleAt(mesh, slot), idOf(mesh, slot), mesh.flags[slot], mesh.tested[slot]});
}

void save(const Mesh& mesh, Vertex vertex, EditLog& log) {
  log.vertices.push_back(
      {vertex, mesh.vertexTriangle[vertex], mesh.vertexEdge[vertex], mesh.kinds[vertex], pointOf(mesh, vertex)});
}

void save(const Mesh& mesh, EdgeId edge, EditLog& log) { log.edges.push_back({edge, mesh.edges[edge]}); }

void saveFlip(const Mesh& mesh, Half half, EditLog& log) {
  const Slot left = triangleOf(half);
  const Slot right = triangleOf(oppositeOf(mesh, half));
  for (const Slot slot : {left, right}) {
    save(mesh, slot, log);
    for (const Half across : triangleAt(mesh, slot).adj)
      if (across.exists() && triangleOf(across) != left && triangleOf(across) != right)
        save(mesh, triangleOf(across), log);
    for (const Vertex v : triangleAt(mesh, slot).v) save(mesh, v, log);
  }
}

void link(Mesh& mesh, Half half, Half other, EditLog& log) {
  save(mesh, triangleOf(half), log);
  if (other.exists()) save(mesh, triangleOf(other), log);
  link(mesh, half, other);
}

Half flipEdge(Mesh& mesh, Half half, EditLog& log) {
  saveFlip(mesh, half, log);
  return flipEdge(mesh, half);
}

Slot addTriangle(Mesh& mesh, Vertex a, Vertex b, Vertex c, EditLog& log) {
  if (!mesh.freeSlots.empty()) {
    const Slot next = mesh.freeSlots.back();
    log.free.push_back(next);
    save(mesh, next, log);
  }
  for (const Vertex v : {a, b, c}) save(mesh, v, log);
  return addTriangle(mesh, a, b, c);
}

void killTriangle(Mesh& mesh, Slot slot, EditLog& log) {
  save(mesh, slot, log);
  log.free.emplace_back();
  killTriangle(mesh, slot);
}

void movePoint(Mesh& mesh, Vertex vertex, Point to, EditLog& log) {
  save(mesh, vertex, log);
  mesh.points[vertex] = to;
}

}  // namespace triscope
