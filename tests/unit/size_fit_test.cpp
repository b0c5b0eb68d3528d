// How well edges go with the lengths wanted, held against a sum over all pairs of vertices that share a triangle.
#include "core/method/size_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/quality/quality.h"
#include "support/meshes.h"
#include "support/optimised.h"
#include "support/runs.h"

namespace triscope::size_fit_test {
namespace {

TEST(SizeFit, IsNothingBeforeThereIsATree) {
  const SizeFit fit = sizeFitOf(support::start(support::domainFrom(support::kFrame)));
  EXPECT_EQ(fit.mean, 0.0);
  EXPECT_EQ(fit.within, 0.0);
}

TEST(SizeFit, LeavesOutWhatReachesToTheBox) {
  const SizeFit fit =
      sizeFitOf(support::after(support::domainAt(support::samples() / "annulus.json"), Stage::recovery));
  EXPECT_LT(fit.mean, 6.0);  // 17 with the box
}

TEST(SizeFit, CountsEveryInnerEdgeOnce) {
  const MeshState state = support::finished(support::domainFrom(support::kCrackedFrame), support::best());
  std::set<std::pair<Vertex, Vertex>> edges;
  for (const auto& corners : support::trianglesOf(state.mesh)) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vertex a = corners[i], b = corners[(i + 1) % 3];
      if (!findBoundaryEdge(state.mesh, a, b).exists()) edges.insert({std::min(a, b), std::max(a, b)});
    }
  }
  double sum = 0.0;
  std::size_t within = 0;
  for (const auto& [a, b] : edges) {
    const Point p = pointOf(state.mesh, a), q = pointOf(state.mesh, b);
    const double ratio = distance(p, q) / edgeLengthAt(state.tree, midpoint(p, q));
    sum += ratio;
    if (std::fabs(std::log2(ratio)) <= 0.5) ++within;
  }
  const SizeFit fit = sizeFitOf(state);
  EXPECT_NEAR(fit.mean, sum / static_cast<double>(edges.size()), 1e-12);
  EXPECT_NEAR(fit.within, static_cast<double>(within) / static_cast<double>(edges.size()), 1e-12);
}

TEST(SizeFit, OfRowsIsCloseToOne) {
  const SizeFit fit =
      sizeFitOf(support::finished(support::domainAt(support::samples() / "naca0012.json"), support::best()));
  EXPECT_NEAR(fit.mean, 1.0, 0.03);
  EXPECT_GT(fit.within, 0.99);
}

}  // namespace
}  // namespace triscope::size_fit_test
