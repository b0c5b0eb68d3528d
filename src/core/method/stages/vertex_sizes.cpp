#include "core/method/stages/vertex_sizes.h"

#include <cmath>

#include "core/density/continuous_size.h"
#include "core/mesh/edit.h"
#include "core/optimise/smooth.h"

namespace triscope {
namespace {

constexpr int kFewestToFit = 24;  // triangles; the mean of fewer is the luck of a few points

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

void fitSizes(MeshState& state) {
  const Mesh& mesh = state.mesh;
  const auto isInner = [&](Vertex v) { return !mesh.vertexEdge[v].exists(); };
  double is = 0.0, wanted = 0.0;  // twice the areas
  int looked = 0;
  for (const Slot slot : mesh.triangles.keys()) {
    if (!mesh.alive(slot)) continue;
    const Corners<Vertex>& v = triangleAt(mesh, slot).v;
    if (!isInner(v[0]) || !isInner(v[1]) || !isInner(v[2])) continue;
    const double size = (state.sizes[v[0]] + state.sizes[v[1]] + state.sizes[v[2]]) / 3.0;
    is += twiceArea(mesh, slot);
    ++looked;
    wanted += kEquilateral * size * size;
  }
  if (looked < kFewestToFit) return;
  const double ratio = std::sqrt(is / wanted);
  for (const Vertex v : state.sizes.keys())
    if (isInner(v)) state.sizes[v] *= ratio;
}

}  // namespace triscope
