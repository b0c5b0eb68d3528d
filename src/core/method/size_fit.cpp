#include "core/method/size_fit.h"

#include "core/mesh/edit.h"
#include "core/mesh/inside_box.h"

namespace triscope {

SizeFit sizeFitOf(const MeshState& state) {
  const Mesh& mesh = state.mesh;
  if (state.tree.cells.empty()) return {};
  LeafPath path;
  std::size_t edges = 0, fitting = 0;
  double sum = 0.0;
  const InsideBox inside(mesh);
  for (const Slot slot : mesh.triangles.keys()) {
    if (!inside.has(slot)) continue;
    for (const Half half : halvesOf(slot)) {
      const Half across = oppositeOf(mesh, half);
      if (!across.exists() || across < half || constrained(mesh, half) || !inside.has(triangleOf(across))) continue;
      const Point a = pointOf(mesh, startOf(mesh, half)), b = pointOf(mesh, endOf(mesh, half));
      const double ratio = distance(a, b) / edgeLengthAt(state.tree, midpoint(a, b), path);
      ++edges;
      sum += ratio;
      if (ratio * ratio >= 0.5 && ratio * ratio <= 2.0) ++fitting;
    }
  }
  if (edges == 0) return {};
  const auto count = static_cast<double>(edges);
  return {sum / count, static_cast<double>(fitting) / count};
}

}  // namespace triscope
