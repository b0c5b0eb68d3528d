#include "core/method/stages/vertex_sizes.h"

#include "core/density/continuous_size.h"
#include "core/mesh/edit.h"

namespace triscope {
namespace {

/// Mean length of the boundary edges that end in a vertex; 0 where none does.
double boundaryLengthAt(const Mesh& mesh, Vertex vertex) {
  double sum = 0.0;
  int count = 0;
  for (EdgeId e = mesh.vertexEdge[vertex]; e.exists(); e = nextEdgeAt(mesh, e, vertex), ++count)
    sum += distance(pointOf(mesh, mesh.edges[e].v0), pointOf(mesh, mesh.edges[e].v1));
  return count > 0 ? sum / count : 0.0;
}

}  // namespace

void extendSizes(MeshState& state, const std::vector<CornerLengths>& corners) {
  const Mesh& mesh = state.mesh;
  LeafPath& path = state.room.placing.path;
  state.sizes.reserve(mesh.points.size());
  for (Vertex v = state.sizes.next(); mesh.points.has(v); ++v) {
    double& size = state.sizes.emplace_back(0.0);
    if (!mesh.vertexTriangle[v].exists()) continue;
    const Point p = pointOf(mesh, v);
    size = corners.empty() ? edgeLengthOf(state.tree, densityRankAt(state.tree, p, path))
                           : continuousLengthAt(state.tree, corners, p, path);
    const double real = boundaryLengthAt(mesh, v);
    if (real > 0.0) size = real < size ? real : 0.5 * (real + size);
  }
}

}  // namespace triscope
