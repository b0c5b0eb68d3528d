// The closed star of a vertex, gathered once: what a trial of a move reads again and again.
#pragma once

#include <vector>

#include "core/mesh/mesh.h"

namespace triscope {

/// A triangle of the star, and the vertex at which its rim begins.
struct Spoke {
  Slot slot;
  int corner = 0;  // of the hub in the triangle
  Half across;     // half-edge beyond the rim, none at a border
  Vertex rim;      // where the rim begins; it ends at that of the next spoke
  Point at;        // of that vertex
};

struct Wheel {
  Vertex hub;
  std::vector<Spoke> spokes;  // counter-clockwise
};

/// Gathers the star of a vertex. False when it is open.
inline bool gather(const Mesh& mesh, Vertex vertex, Wheel& wheel) {
  wheel.hub = vertex;
  wheel.spokes.clear();
  const Slot first = mesh.vertexTriangle[vertex];
  Slot slot = first;
  do {
    const Triangle& t = triangleAt(mesh, slot);
    const int corner = cornerOf(t, vertex);
    const Half across = t.adj[next3(corner)];
    if (!across.exists()) return false;
    const Vertex rim = t.v[next3(corner)];
    wheel.spokes.push_back({slot, corner, t.adj[corner], rim, pointOf(mesh, rim)});
    slot = triangleOf(across);
  } while (slot != first);
  return true;
}

}  // namespace triscope
