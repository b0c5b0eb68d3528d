// The closed star of a vertex, gathered once: what a trial of a move reads again and again.
#pragma once

#include <vector>

#include "core/mesh/mesh.h"

namespace triscope {

/// A triangle of the star, and the vertex at which its rim begins.
struct Spoke {
  std::int32_t slot = -1;
  std::int32_t corner = 0;   // of the hub in the triangle
  std::int32_t across = -1;  // half-edge beyond the rim, -1 at a border
  std::int32_t rim = -1;     // vertex where the rim begins; it ends at that of the next spoke
  Point at;                  // of that vertex
};

struct Wheel {
  std::int32_t hub = -1;
  std::vector<Spoke> spokes;  // counter-clockwise
};

/// Gathers the star of a vertex. False when it is open.
inline bool gather(const Mesh& mesh, std::int32_t vertex, Wheel& wheel) {
  wheel.hub = vertex;
  wheel.spokes.clear();
  const std::int32_t first = mesh.vertexTriangle[static_cast<std::size_t>(vertex)];
  std::int32_t slot = first;
  do {
    const Triangle& t = triangleAt(mesh, slot);
    const int corner = t.v[0] == vertex ? 0 : t.v[1] == vertex ? 1 : 2;
    const std::int32_t across = t.adj[static_cast<std::size_t>(next3(corner))];
    if (across < 0) return false;
    const std::int32_t rim = t.v[static_cast<std::size_t>(next3(corner))];
    wheel.spokes.push_back({slot, corner, t.adj[static_cast<std::size_t>(corner)], rim, pointOf(mesh, rim)});
    slot = triangleOf(across);
  } while (slot != first);
  return true;
}

}  // namespace triscope
