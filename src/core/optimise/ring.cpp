#include "core/optimise/ring.h"

namespace triscope {
namespace {

int cornerAt(const Triangle& triangle, Vertex vertex) {
  return triangle.v[0] == vertex ? 0 : triangle.v[1] == vertex ? 1 : 2;
}

// The first triangle of the star, counter-clockwise; any one of a star that is closed.
Slot firstOf(const Mesh& mesh, Vertex hub) {
  const Slot begun = mesh.vertexTriangle[hub];
  if (!mesh.vertexEdge[hub].exists()) return begun;
  Slot slot = begun;
  for (;;) {
    const Triangle& triangle = triangleAt(mesh, slot);
    const Half across = triangle.adj[prev3(cornerAt(triangle, hub))];
    if (!across.exists()) return slot;
    slot = triangleOf(across);
    if (slot == begun) return slot;
  }
}

}  // namespace

bool gatherLinks(const Mesh& mesh, Vertex hub, Ring& ring) {
  ring.count = 0;
  ring.closed = false;
  if (!mesh.vertexTriangle[hub].exists()) return false;
  const Slot first = firstOf(mesh, hub);
  Slot slot = first;
  for (;;) {
    if (ring.count == Ring::kMost) return false;
    const Triangle& triangle = triangleAt(mesh, slot);
    const int corner = cornerAt(triangle, hub);
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
