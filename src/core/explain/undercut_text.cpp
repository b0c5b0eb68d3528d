#include "core/explain/undercut_text.h"

#include <fmt/format.h>

#include "core/base/shown_text.h"
#include "core/domain/loop_of.h"
#include "core/explain/fields.h"
#include "core/mesh/edit.h"

namespace triscope {
namespace {

constexpr double kRounding = 1.0 - 1e-9;  // an edge meant to be as long as was asked may come out this much shorter

Half shortestEdgeOf(const Mesh& mesh, Slot slot) {
  Half shortest = halfOf(slot, 0);
  for (const Half half : halvesOf(slot)) {
    const auto squaredLength = [&](Half h) {
      return squaredDistance(pointOf(mesh, startOf(mesh, h)), pointOf(mesh, endOf(mesh, h)));
    };
    if (squaredLength(half) < squaredLength(shortest)) shortest = half;
  }
  return shortest;
}

}  // namespace

std::string undercutText(const MeshState& state, const Quality& quality) {
  if (state.minEdgeDerived || !quality.minEdgeAt.exists() || quality.minEdge >= kRounding * shortestMeant(state))
    return {};
  const Mesh& mesh = state.mesh;
  const Half half = shortestEdgeOf(mesh, quality.minEdgeAt);
  const Vertex a = startOf(mesh, half), b = endOf(mesh, half);
  const Point middle = midpoint(pointOf(mesh, a), pointOf(mesh, b));
  const EdgeId edge = findBoundaryEdge(mesh, a, b);
  const std::string why =
      edge.exists() ? fmt::format("it is a piece of '{}'", shown(loopOf(*state.domain, mesh.edges[edge].curve).name))
                    : "it is near kept edges, a gap or a sharp corner that leave no room for longer ones";
  return fmt::format("the shortest edge, {:.4g} at {}, is below the min_edge_length given, {:g}: {}", quality.minEdge,
                     placeText(middle), state.minEdge, why);
}

}  // namespace triscope
