#include "core/mesh/edit.h"

#include "core/base/assert.h"
#include "core/mesh/change_log.h"

namespace triscope {

Vertex addVertex(Mesh& mesh, Point p, VertexKind kind, std::uint8_t density) {
  mesh.points.push_back(p);
  mesh.kinds.push_back(kind);
  mesh.density.push_back(density);
  mesh.vertexTriangle.emplace_back();
  mesh.vertexEdge.emplace_back();
  return Vertex(mesh.points.size() - 1);
}

Slot takeSlot(Mesh& mesh) {
  if (mesh.freeSlots.empty()) {
    TRISCOPE_CHECK(mesh.triangles.size() < kMostSlots, "half-edges are numbered in 32 bits");
    mesh.triangles.emplace_back();
    mesh.ids.emplace_back();
    mesh.flags.push_back(kDead);
    mesh.tested.push_back(0);
    return Slot(mesh.triangles.size() - 1);
  }
  const Slot slot = mesh.freeSlots.back();
  mesh.freeSlots.pop_back();
  TRISCOPE_CHECK(!mesh.alive(slot), "a free slot holds no triangle");
  return slot;
}

Slot addTriangle(Mesh& mesh, Vertex a, Vertex b, Vertex c) {
  TRISCOPE_CHECK(a != b && b != c && c != a, "a triangle has three corners");
  const Slot slot = takeSlot(mesh);
  mesh.flags[slot] = 0;
  mesh.tested[slot] = 0;
  mesh.triangles[slot] = {{a, b, c}, {}};
  mesh.ids[slot] = mesh.nextId++;
  noteTouched(mesh, slot);
  mesh.vertexTriangle[a] = slot;
  mesh.vertexTriangle[b] = slot;
  mesh.vertexTriangle[c] = slot;
  return slot;
}

void killTriangle(Mesh& mesh, Slot slot) {
  TRISCOPE_CHECK(mesh.alive(slot), "a triangle is removed once");
  mesh.flags[slot] = kDead;
  mesh.tested[slot] = kTestedAll;
  mesh.freeSlots.push_back(slot);
  noteTouched(mesh, slot);
}

Slot firstInStar(const Mesh& mesh, Vertex vertex) {
  const Slot begun = mesh.vertexTriangle[vertex];
  Slot slot = begun;
  do {
    const Triangle& triangle = triangleAt(mesh, slot);
    const Half across = triangle.adj[prev3(cornerOf(triangle, vertex))];
    if (!across.exists()) return slot;
    slot = triangleOf(across);
  } while (slot != begun);
  return begun;
}

void starOf(const Mesh& mesh, Vertex vertex, Star& star) {
  star.rim.clear();
  star.closed = false;
  if (!mesh.vertexTriangle[vertex].exists()) return;
  const Slot start = firstInStar(mesh, vertex);
  Slot slot = start;
  for (;;) {
    const Triangle& triangle = triangleAt(mesh, slot);
    const int corner = cornerOf(triangle, vertex);
    star.rim.push_back(halfOf(slot, corner));
    const Half across = triangle.adj[next3(corner)];
    if (!across.exists()) return;
    slot = triangleOf(across);
    if (slot == start) break;
  }
  star.closed = true;
}

Half findHalfEdge(const Mesh& mesh, Vertex a, Vertex b) {
  const Slot first = mesh.vertexTriangle[a];
  if (!first.exists()) return {};
  for (int direction = 0; direction < 2; ++direction) {
    Slot slot = first;
    do {
      const Triangle& triangle = triangleAt(mesh, slot);
      const int corner = cornerOf(triangle, a);
      if (triangle.v[next3(corner)] == b) return halfOf(slot, prev3(corner));
      const int side = direction == 0 ? next3(corner) : prev3(corner);
      const Half across = triangle.adj[side];
      if (!across.exists()) break;
      slot = triangleOf(across);
    } while (slot != first);
  }
  return {};
}

Half edgeBetween(const Mesh& mesh, Vertex a, Vertex b) {
  const Half half = findHalfEdge(mesh, a, b);
  return half.exists() ? half : findHalfEdge(mesh, b, a);
}

EdgeId addBoundaryEdge(Mesh& mesh, const BoundaryEdge& edge) {
  TRISCOPE_CHECK(edge.v0 != edge.v1, "a boundary edge has two ends");
  const EdgeId index = mesh.edges.next();
  mesh.edges.push_back(edge);
  mesh.edges.back().next0 = mesh.vertexEdge[edge.v0];
  mesh.vertexEdge[edge.v0] = index;
  mesh.edges.back().next1 = mesh.vertexEdge[edge.v1];
  mesh.vertexEdge[edge.v1] = index;
  return index;
}

EdgeId findBoundaryEdge(const Mesh& mesh, Vertex a, Vertex b) {
  for (EdgeId e = mesh.vertexEdge[a]; e.exists();) {
    const BoundaryEdge& edge = mesh.edges[e];
    if ((edge.v0 == a && edge.v1 == b) || (edge.v0 == b && edge.v1 == a)) return e;
    e = edge.v0 == a ? edge.next0 : edge.next1;
  }
  return {};
}

EdgeId splitBoundaryEdge(Mesh& mesh, EdgeId e, Vertex middle, double t) {
  const BoundaryEdge old = mesh.edges[e];
  const auto rest = mesh.edges.next();
  // In the list of v1 the new edge takes the old one's place.
  EdgeId* link = &mesh.vertexEdge[old.v1];
  while (*link != e) {
    TRISCOPE_CHECK(link->exists(), "a boundary edge is in the lists of both its ends");
    BoundaryEdge& step = mesh.edges[*link];
    link = step.v0 == old.v1 ? &step.next0 : &step.next1;
  }
  *link = rest;
  mesh.edges[e] = {old.v0, middle, old.curve, old.next0, rest, old.t0, t};
  mesh.edges.push_back({middle, old.v1, old.curve, {}, old.next1, t, old.t1});
  mesh.vertexEdge[middle] = e;
  return rest;
}

}  // namespace triscope
