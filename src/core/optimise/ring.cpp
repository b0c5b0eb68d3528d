#include "core/optimise/ring.h"

#include "core/mesh/edit.h"

namespace triscope {

bool gatherLinks(const Mesh& mesh, Vertex hub, Ring& ring) {
  ring.count = 0;
  ring.closed = false;
  if (!mesh.vertexTriangle[hub].exists()) return false;
  // Where a star is closed it may begin anywhere.
  const bool inner = !mesh.vertexEdge[hub].exists();
  const Slot first = inner ? mesh.vertexTriangle[hub] : firstInStar(mesh, hub);
  Slot slot = first;
  for (;;) {
    if (ring.count == Ring::kMost) return false;
    const Triangle& triangle = triangleAt(mesh, slot);
    const int corner = cornerOf(triangle, hub);
    const auto k = static_cast<std::size_t>(ring.count++);
    ring.rim[k] = halfOf(slot, corner);
    ring.vertices[k] = triangle.v[next3(corner)];
    const Half across = triangle.adj[next3(corner)];
    if (!across.exists()) {
      ring.vertices[k + 1] = triangle.v[prev3(corner)];
      return true;
    }
    slot = triangleOf(across);
    if (slot != first) continue;
    ring.vertices[k + 1] = ring.vertices[0];
    ring.closed = true;
    return true;
  }
}

bool gatherRing(const Mesh& mesh, const Sizes& sizes, Vertex hub, Ring& ring) {
  if (!gatherLinks(mesh, hub, ring)) return false;
  for (std::size_t k = 0; k <= static_cast<std::size_t>(ring.count); ++k) {
    ring.at[k] = pointOf(mesh, ring.vertices[k]);
    ring.sizes[k] = sizes[ring.vertices[k]];
  }
  return true;
}

}  // namespace triscope
