// What lies under the cursor: vertex before edge before triangle before quadtree cell.
#pragma once

#include "core/base/point.h"
#include "core/method/state.h"
#include "render/view_options.h"

namespace triscope {

struct Pick {
  Selection selection;
  std::uint32_t id = kNoId;  // triangle id (triangle and edge), vertex index, or cell index
  double distance = 0.0;     // world, from the point to the vertex or edge; 0 inside a triangle or cell
};

/// A triangle, or a vertex, as if it had been picked.
Pick pickOf(const Mesh& mesh, Slot slot);
Pick pickOf(Vertex vertex);

/// Looks within `reach` (world units: 8 px / camera.scale) of p. Cells are found only where there is no triangle, or
/// by pickCellFirst(), which looks for a cell before vertices, edges and triangles.
Pick pick(const MeshState& state, Point p, double reach);
Pick pickCellFirst(const MeshState& state, Point p, double reach);

/// Whether the state has this element: a live triangle, a vertex not removed, a cell. Kind none it has not.
bool isPartOf(const MeshState& state, const Selection& selection);

/// Where what was picked is in a state, which may be earlier or later than the one that it was picked in: its id says
/// what is meant, also when its slot has been reused. Kind none when it is not part of the state.
Selection present(const MeshState& state, const Pick& pick);

/// Slot of the live triangle that contains p (an edge counts as inside), none outside the mesh. A walk from
/// Mesh::lastTriangle; falls back to looking at every triangle where a hole stops the walk.
Slot triangleContaining(const Mesh& mesh, Point p);

}  // namespace triscope
