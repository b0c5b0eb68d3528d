#include "core/method/stages/limits.h"

#include <algorithm>
#include <cmath>

namespace triscope {
namespace {

constexpr std::uint64_t kAtLeast = 1000;
constexpr std::uint64_t kSplitsEach = 64;
constexpr std::size_t kTimesForeseen = 8;

}  // namespace

double shortestMade(const MeshState& state) {
  const Box& box = state.domain->bounds;
  const double largest = std::max({std::fabs(box.lo.x), std::fabs(box.lo.y), std::fabs(box.hi.x), std::fabs(box.hi.y)});
  return std::max(0x1p-24 * std::min(state.minEdge, state.tree.minEdge), 0x1p-46 * largest);
}

std::uint64_t mostSplits(const MeshState& state) { return kAtLeast + kSplitsEach * state.boundary.size(); }

std::size_t mostVertices(const MeshState& state) {
  const double foreseen = std::min(state.estimatedTriangles, 1e12) + static_cast<double>(state.boundary.size());
  return kAtLeast + kTimesForeseen * static_cast<std::size_t>(foreseen);
}

std::uint64_t mostRepairs(const MeshState& state) { return kAtLeast + state.mesh.liveCount(); }

}  // namespace triscope
