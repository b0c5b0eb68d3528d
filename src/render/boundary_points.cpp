#include "render/boundary_points.h"

namespace triscope {

std::vector<std::size_t> distinctBoundaryPoints(const MeshState& state) {
  // The far end of a curve is the near end of the next one, except at the end of an open chain.
  std::vector<char> endsChain(state.domain ? state.domain->curves.size() : 0, 0);
  if (state.domain) {
    for (const Loop& loop : state.domain->loops) {
      if (loop.role == LoopRole::chain && loop.curveCount > 0) endsChain[loop.firstCurve + loop.curveCount - 1] = 1;
    }
  }
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < state.boundary.size(); ++i) {
    const BoundaryPoint& p = state.boundary[i];
    const bool repeated = p.kept && p.t == 1.0 && p.curve < endsChain.size() && endsChain[p.curve] == 0;
    if (!repeated) indices.push_back(i);
  }
  return indices;
}

}  // namespace triscope
