#include "core/mesh/patch.h"

#include "core/base/assert.h"
#include "core/mesh/edit.h"

namespace triscope {

void extractPatch(const Mesh& mesh, std::int32_t slot, int depth, Patch& patch) {
  std::vector<std::int32_t>& localSlot = patch.localSlot;
  std::vector<std::int32_t>& localVertex = patch.localVertex;
  if (localSlot.size() < mesh.triangles.size()) localSlot.resize(mesh.triangles.size(), -1);
  if (localVertex.size() < mesh.points.size()) localVertex.resize(mesh.points.size(), -1);

  TRISCOPE_CHECK(localSlot[at(slot)] == -1, "the patch before left no trace");
  patch.slots.assign(1, slot);
  patch.vertices.clear();
  patch.edges.clear();
  localSlot[at(slot)] = 0;
  std::size_t ringBegin = 0;
  for (int ring = 0; ring < depth; ++ring) {
    const std::size_t ringEnd = patch.slots.size();
    for (; ringBegin < ringEnd; ++ringBegin) {
      for (int i = 0; i < 3; ++i) {
        const std::int32_t half = 3 * patch.slots[ringBegin] + i;
        const std::int32_t across = oppositeOf(mesh, half);
        if (across < 0 || constrained(mesh, half) || localSlot[at(triangleOf(across))] >= 0) continue;
        localSlot[at(triangleOf(across))] = static_cast<std::int32_t>(patch.slots.size());
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
  small.lastTriangle = 0;
  for (std::size_t k = 0; k < patch.slots.size(); ++k) {
    const std::int32_t source = patch.slots[k];
    Triangle triangle = triangleAt(mesh, source);
    std::uint8_t flags = mesh.flags[at(source)];
    for (std::size_t i = 0; i < 3; ++i) {
      std::int32_t& local = localVertex[at(triangle.v[i])];
      if (local < 0) {
        local = static_cast<std::int32_t>(patch.vertices.size());
        patch.vertices.push_back(triangle.v[i]);
        addVertex(small, pointOf(mesh, triangle.v[i]), mesh.kinds[at(triangle.v[i])], mesh.density[at(triangle.v[i])]);
      }
      triangle.v[i] = local;
      small.vertexTriangle[at(local)] = static_cast<std::int32_t>(k);
      const std::int32_t across = triangle.adj[i];
      const std::int32_t other = across < 0 ? -1 : localSlot[at(triangleOf(across))];
      triangle.adj[i] = other < 0 ? -1 : 3 * other + cornerOf(across);
      if (other < 0) flags = static_cast<std::uint8_t>(flags | 1u << i);
    }
    small.triangles.push_back(triangle);
    small.ids.push_back(idOf(mesh, source));
    small.flags.push_back(flags);
    small.tested.push_back(mesh.tested[at(source)]);
  }
  // Each boundary edge once, found from the end with the lower patch index.
  for (std::size_t local = 0; local < patch.vertices.size(); ++local) {
    const std::int32_t vertex = patch.vertices[local];
    for (std::int32_t e = mesh.vertexEdge[at(vertex)]; e >= 0;) {
      const BoundaryEdge& edge = mesh.edges[at(e)];
      const std::int32_t other = edge.v0 == vertex ? edge.v1 : edge.v0;
      const std::int32_t otherLocal = localVertex[at(other)];
      if (otherLocal > static_cast<std::int32_t>(local)) {
        BoundaryEdge copy = edge;
        copy.v0 = localVertex[at(edge.v0)];
        copy.v1 = localVertex[at(edge.v1)];
        addBoundaryEdge(small, copy);
        patch.edges.push_back(e);
      }
      e = edge.v0 == vertex ? edge.next0 : edge.next1;
    }
  }
  for (const std::int32_t source : patch.slots) localSlot[at(source)] = -1;
  for (const std::int32_t vertex : patch.vertices) localVertex[at(vertex)] = -1;
}

}  // namespace triscope
