#include "core/mesh/patch.h"

#include "core/base/assert.h"
#include "core/mesh/edit.h"

namespace triscope {

void extractPatch(const Mesh& mesh, Slot slot, int depth, Patch& patch) {
  Per<Slot, Slot>& localSlot = patch.localSlot;
  Per<Vertex, Vertex>& localVertex = patch.localVertex;
  if (localSlot.size() < mesh.triangles.size()) localSlot.resize(mesh.triangles.size());
  if (localVertex.size() < mesh.points.size()) localVertex.resize(mesh.points.size());

  TRISCOPE_CHECK(!localSlot[slot].exists(), "the patch before left no trace");
  patch.slots.assign(1, slot);
  patch.vertices.clear();
  patch.edges.clear();
  localSlot[slot] = Slot(0);
  Slot ringBegin(0);
  for (int ring = 0; ring < depth; ++ring) {
    const Slot ringEnd = patch.slots.next();
    for (; ringBegin < ringEnd; ++ringBegin) {
      for (int i = 0; i < 3; ++i) {
        const Half half = halfOf(patch.slots[ringBegin], i);
        const Half across = oppositeOf(mesh, half);
        if (!across.exists() || constrained(mesh, half) || localSlot[triangleOf(across)].exists()) continue;
        localSlot[triangleOf(across)] = patch.slots.next();
        patch.slots.push_back(triangleOf(across));
      }
    }
  }

  Mesh& small = patch.mesh;
  small.points.clear();
  small.kinds.clear();
  small.density.clear();
  small.vertexTriangle.clear();
  small.vertexEdge.clear();
  small.triangles.clear();
  small.ids.clear();
  small.flags.clear();
  small.tested.clear();
  small.freeSlots.clear();
  small.edges.clear();
  small.nextId = mesh.nextId;
  small.lastTriangle = Slot(0);
  for (const Slot k : patch.slots.keys()) {
    const Slot source = patch.slots[k];
    Triangle triangle = triangleAt(mesh, source);
    std::uint8_t flags = mesh.flags[source];
    for (int i = 0; i < 3; ++i) {
      const Vertex vertex = triangle.v[i];
      Vertex& local = localVertex[vertex];
      if (!local.exists()) {
        local = patch.vertices.next();
        patch.vertices.push_back(vertex);
        addVertex(small, pointOf(mesh, vertex), mesh.kinds[vertex], mesh.density[vertex]);
      }
      triangle.v[i] = local;
      small.vertexTriangle[local] = k;
      const Half across = triangle.adj[i];
      const Slot other = across.exists() ? localSlot[triangleOf(across)] : Slot();
      triangle.adj[i] = other.exists() ? halfOf(other, cornerOf(across)) : Half();
      if (!other.exists()) flags = static_cast<std::uint8_t>(flags | 1u << i);
    }
    small.triangles.push_back(triangle);
    small.ids.push_back(idOf(mesh, source));
    small.flags.push_back(flags);
    small.tested.push_back(mesh.tested[source]);
  }
  // Each boundary edge once, found from the end with the lower patch index.
  for (const Vertex local : patch.vertices.keys()) {
    const Vertex vertex = patch.vertices[local];
    for (EdgeId e = mesh.vertexEdge[vertex]; e.exists();) {
      const BoundaryEdge& edge = mesh.edges[e];
      const Vertex other = edge.v0 == vertex ? edge.v1 : edge.v0;
      const Vertex otherLocal = localVertex[other];
      if (otherLocal > local) {
        BoundaryEdge copy = edge;
        copy.v0 = localVertex[edge.v0];
        copy.v1 = localVertex[edge.v1];
        addBoundaryEdge(small, copy);
        patch.edges.push_back(e);
      }
      e = edge.v0 == vertex ? edge.next0 : edge.next1;
    }
  }
  for (const Slot source : patch.slots) localSlot[source] = {};
  for (const Vertex vertex : patch.vertices) localVertex[vertex] = {};
}

}  // namespace triscope
