// The points of the triangulation, and the fronts.
#include <algorithm>
#include <iterator>

#include "core/density/wanted.h"
#include "core/mesh/edit.h"
#include "render/boundary_points.h"
#include "render/scene_parts.h"
#include "render/scene_shapes.h"

namespace triscope::detail {
using std::size_t;

float spacingOf(const MeshState& state, Vertex vertex) {
  return static_cast<float>(edgeLengthOf(state.tree, std::max<int>(1, state.mesh.density[vertex])));
}

void buildPoints(const SceneInput& in, Layer& layer) {
  const MeshState& state = in.state;
  const Theme& theme = in.theme;
  MarkBatch placed = markBatch(Shape::circle, 4.0f, theme.placed, {0, 0, 0, 0});
  MarkBatch kept = markBatch(Shape::square, 5.0f, theme.kept, {0, 0, 0, 0});
  MarkBatch split = markBatch(Shape::ring, 5.5f, theme.placed, {0, 0, 0, 0});
  MarkBatch steiner = markBatch(Shape::triangle, 5.5f, theme.steiner, {0, 0, 0, 0});
  const auto add = [](MarkBatch& batch, Point p, float spacing) {
    batch.at.push_back(p);
    batch.spacing.push_back(spacing);
  };
  if (in.options.boundaryPoints && state.mesh.points.empty()) {
    for (const size_t index : distinctBoundaryPoints(state)) {
      const BoundaryPoint& p = state.boundary[index];
      add(p.kept ? kept : placed, p.at, static_cast<float>(wantedAt(state.tree, p.at).value_or(Wanted{}).length));
    }
  }
  for (const Vertex v : state.mesh.points.keys()) {
    const VertexKind kind = state.mesh.kinds[v];
    if (kind < VertexKind::kept || kind > VertexKind::steiner) continue;
    const bool onBoundary = kind <= VertexKind::split;
    const bool wanted = onBoundary ? in.options.boundaryPoints : in.options.steiner && kind == VertexKind::steiner;
    if (!wanted) continue;
    MarkBatch& batch = kind == VertexKind::kept       ? kept
                       : kind == VertexKind::boundary ? placed
                       : kind == VertexKind::split    ? split
                                                      : steiner;
    add(batch, state.mesh.points[v], spacingOf(state, v));
  }
  for (MarkBatch* batch : {&steiner, &placed, &split, &kept}) {
    if (!batch->at.empty()) layer.marks.push_back(std::move(*batch));
  }
}

std::vector<Vertex> frontInMesh(const Mesh& mesh, const std::vector<Vertex>& front) {
  std::vector<Vertex> there;
  std::copy_if(front.begin(), front.end(), std::back_inserter(there),
               [&mesh](Vertex vertex) { return mesh.points.has(vertex) && mesh.kinds[vertex] != VertexKind::removed; });
  return there;
}

void buildFronts(const SceneInput& in, Layer& layer) {
  if (!in.options.fronts) return;
  const Mesh& mesh = in.state.mesh;
  const auto add = [&](const std::vector<Vertex>& front, Shape shape, float size, Color color) {
    MarkBatch batch = markBatch(shape, size, color, in.theme.background);
    for (const Vertex vertex : frontInMesh(mesh, front)) {
      batch.at.push_back(mesh.points[vertex]);
      batch.spacing.push_back(spacingOf(in.state, vertex));
    }
    if (!batch.at.empty()) layer.marks.push_back(std::move(batch));
  };
  add(in.state.front1, Shape::circle, 7.0f, in.theme.front1);
  add(in.state.front2, Shape::diamond, 8.5f, in.theme.front2);
}

}  // namespace triscope::detail
