#include "core/density/continuous_size.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/domains.h"
#include "support/random.h"
#include "support/runs.h"

namespace triscope::continuous_size_test {
namespace {

using support::Random;

const Quadtree& treeOf(const MeshState& state) { return state.tree; }

TEST(ContinuousSize, IsTheSameFromBothSidesOfEveryCell) {
  for (const char* const file : {"naca0012.json", "blunt_body.json", "cracked_plate.json"}) {
    const MeshState state = support::after(support::domainAt(support::samples() / file), Stage::density);
    const Quadtree& tree = treeOf(state);
    const std::vector<CornerLengths> corners = continuousLengths(tree);
    LeafPath path;
    Random random{3};
    int looked = 0, jumps = 0;
    for (const Cell& cell : tree.cells) {
      if (cell.child >= 0) continue;
      const double side = tree.side(cell), gap = 1e-9 * side;
      const Point low = tree.corner(cell);
      for (int k = 0; k < 4; ++k) {
        const double along = random.between(0.0, side);
        const bool vertical = k % 2 == 0;
        const Point at = vertical ? low + Point{side, along} : low + Point{along, side};
        const Point across = vertical ? Point{gap, 0} : Point{0, gap};
        const double before = continuousLengthAt(tree, corners, at - across, path);
        const double after = continuousLengthAt(tree, corners, at + across, path);
        ASSERT_NEAR(before, after, 1e-6 * before) << file << " at " << at.x << ", " << at.y;
        jumps += densityRankAt(tree, at - across) != densityRankAt(tree, at + across) ? 1 : 0;
        ++looked;
      }
    }
    EXPECT_GT(looked, 300);
    EXPECT_GT(jumps, 20) << "where ranks differ it matters";
  }
}

TEST(ContinuousSize, StaysWithinTheLengthsOfTheRanksAndNearTheCells) {
  const MeshState state = support::after(support::domainAt(support::samples() / "naca0012.json"), Stage::density);
  const Quadtree& tree = state.tree;
  const std::vector<CornerLengths> corners = continuousLengths(tree);
  double shortest = 1e300, longest = 0.0;
  for (const Cell& cell : tree.cells) {
    if (cell.child >= 0) continue;
    shortest = std::min(shortest, edgeLengthOf(tree, cell.density));
    longest = std::max(longest, edgeLengthOf(tree, cell.density));
  }
  Random random{9};
  LeafPath path;
  const Box& box = state.domain->bounds;
  for (int k = 0; k < 5000; ++k) {
    const Point p{random.between(box.lo.x, box.hi.x), random.between(box.lo.y, box.hi.y)};
    const double length = continuousLengthAt(tree, corners, p, path);
    ASSERT_GE(length, shortest * (1 - 1e-6));
    ASSERT_LE(length, longest * (1 + 1e-6));
    const double ofRank = edgeLengthOf(tree, densityRankAt(tree, p));
    ASSERT_LT(length, 1.8 * ofRank) << "two ranks and more away at " << p.x << ", " << p.y;
    ASSERT_GT(length, ofRank / 1.8);
  }
}

TEST(ContinuousSize, IsTheTreesOwnWhereTheSettingSaysSo) {
  const support::DomainPtr domain = support::domainFrom(support::kRound);
  Settings continuous;
  continuous.size = SizeField::continuous;
  const MeshState ranks = support::after(domain, Stage::density);
  const MeshState smooth = support::after(domain, Stage::density, continuous);
  const Point at{1.3, -0.4};
  LeafPath path;
  EXPECT_TRUE(ranks.tree.corners.empty());
  EXPECT_EQ(edgeLengthAt(ranks.tree, at), edgeLengthOf(ranks.tree, densityRankAt(ranks.tree, at)));
  EXPECT_EQ(edgeLengthAt(smooth.tree, at), continuousLengthAt(ranks.tree, continuousLengths(ranks.tree), at, path));
}

TEST(ContinuousSize, OfOneCellIsThatOfTheCell) {
  const MeshState state = support::after(
      support::domainFrom(R"({"outer": [[0, 0], [1, 0], [1, 1], [0, 1]], "min_edge_length": 0.9})"), Stage::density);
  const std::vector<CornerLengths> corners = continuousLengths(state.tree);
  LeafPath path;
  EXPECT_NEAR(continuousLengthAt(state.tree, corners, {0.3, 0.8}, path), edgeLengthAt(state.tree, {0.3, 0.8}), 1e-6);
  EXPECT_NEAR(continuousLengthAt(state.tree, corners, {-900, 7000}, path), edgeLengthAt(state.tree, {0.3, 0.8}), 1e-6);
}

}  // namespace
}  // namespace triscope::continuous_size_test
