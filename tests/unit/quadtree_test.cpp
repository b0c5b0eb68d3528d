// The background quadtree (paper, section 2, Table 1) against a look at every cell.
#include "core/density/quadtree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/random.h"
#include "support/runs.h"

namespace triscope::quadtree_test {
namespace {

using support::Random;

const Cell& cellAt(const Quadtree& tree, std::int32_t index) { return tree.cells[static_cast<std::size_t>(index)]; }

std::uint32_t sideOf(const Cell& cell) { return 1u << (cell.rank - 1); }

std::vector<std::int32_t> leavesOf(const Quadtree& tree) {
  std::vector<std::int32_t> leaves;
  for (std::size_t k = 0; k < tree.cells.size(); ++k) {
    if (tree.cells[k].child < 0) leaves.push_back(static_cast<std::int32_t>(k));
  }
  return leaves;
}

// True when the two squares share more than a corner.
bool shareASide(const Cell& a, const Cell& b) {
  const auto overlap = [](std::uint32_t lo, std::uint32_t loSide, std::uint32_t other, std::uint32_t otherSide) {
    return static_cast<std::int64_t>(std::min(lo + loSide, other + otherSide)) -
           static_cast<std::int64_t>(std::max(lo, other));
  };
  const std::int64_t x = overlap(a.x, sideOf(a), b.x, sideOf(b));
  const std::int64_t y = overlap(a.y, sideOf(a), b.y, sideOf(b));
  return (x == 0 && y > 0) || (y == 0 && x > 0);
}

Quadtree randomTree(Random& random, int splits) {
  Quadtree tree = rootOver({{-1, 2}, {60, 50}}, 0.25);
  for (int k = 0; k < splits; ++k) {
    const std::vector<std::int32_t> leaves = leavesOf(tree);
    const std::int32_t leaf = leaves[random.below(leaves.size())];
    if (cellAt(tree, leaf).rank > 1) splitCell(tree, leaf);
  }
  return tree;
}

TEST(RankLength, GrowsByTheCubeRootOfTwo) {
  EXPECT_EQ(rankLength(1), 1.0);
  EXPECT_EQ(rankLength(4), 2.0);
  EXPECT_EQ(rankLength(31), 1024.0);
  for (int rank = 1; rank <= 96; ++rank) {
    EXPECT_NEAR(rankLength(rank), std::pow(2.0, (rank - 1) / 3.0), 1e-15 * rankLength(rank));
  }
}

TEST(RankAtMost, IsTheLargestRankNotLonger) {
  EXPECT_EQ(rankAtMost(0.3), 1);
  EXPECT_EQ(rankAtMost(1.0), 1);
  EXPECT_EQ(rankAtMost(1.26), 2);
  EXPECT_EQ(rankAtMost(1.999999), 3);
  EXPECT_EQ(rankAtMost(2.0), 4);
  for (int rank = 1; rank < 96; ++rank) {
    EXPECT_EQ(rankAtMost(rankLength(rank)), rank);
    EXPECT_EQ(rankAtMost(rankLength(rank) * (1 + 1e-12)), rank);
    if (rank > 1) {
      EXPECT_EQ(rankAtMost(rankLength(rank) * (1 - 1e-12)), rank - 1);
    }
  }
}

// Table 1: density ranks 1, 2 live in cells of rank 1; 3 in 1 or 2; 4, 5 in 2; 6 in 2 or 3; …
TEST(Table1, SaysWhichCellMayHoldWhichDensity) {
  constexpr int smallest[] = {1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4};
  constexpr int largest[] = {1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4, 5};
  for (int rank = 1; rank <= 12; ++rank) {
    EXPECT_EQ(smallestCellRank(rank), smallest[rank - 1]) << rank;
    EXPECT_EQ(largestCellRank(rank), largest[rank - 1]) << rank;
  }
}

// Its fifth column, 2 (side / h)²: 32, 20.2, then 12.7 or 50.8, and so on with the same ratios.
TEST(Table1, EstimatesTrianglesPerCell) {
  EXPECT_DOUBLE_EQ(trianglesInCell(1, 1), 32.0);
  EXPECT_NEAR(trianglesInCell(1, 2), 20.16, 0.01);
  EXPECT_NEAR(trianglesInCell(1, 3), 12.70, 0.01);
  EXPECT_NEAR(trianglesInCell(2, 3), 50.80, 0.01);
  for (int rank = 1; rank < 20; ++rank) {
    EXPECT_DOUBLE_EQ(trianglesInCell(3, rank + 3), trianglesInCell(2, rank));
  }
}

TEST(RootOver, IsTheSmallestSquareThatHoldsTheBox) {
  for (const double extent : {0.5, 4.0, 4.0001, 8.0, 100.0, 4096.0, 5000.0}) {
    for (const double scale : {1e-9, 1.0, 1e7}) {
      Box box;
      box.include({3 * scale, 2 * scale});
      box.include({(3 + extent) * scale, (2 + 0.3 * extent) * scale});
      const Quadtree tree = rootOver(box, scale);
      ASSERT_EQ(tree.cells.size(), 1u);
      const Cell& root = tree.cells[0];
      const double side = tree.side(root);
      EXPECT_GE(side, box.width());
      EXPECT_EQ(side, 4.0 * scale * sideOf(root));
      if (root.rank > 1) {
        EXPECT_LT(0.5 * side, box.width()) << "half of it would do";
      }
      const double slack = 1e-12 * side;
      EXPECT_LE(tree.corner(root).x, box.lo.x + slack);
      EXPECT_LE(tree.corner(root).y, box.lo.y + slack);
      EXPECT_GE(tree.corner(root).x + side, box.hi.x - slack);
      EXPECT_GE(tree.corner(root).y + side, box.hi.y - slack);
    }
  }
}

TEST(SplitCell, GivesFourQuartersThatInheritWhatTheyMayHold) {
  Quadtree tree = rootOver({{0, 0}, {32, 32}}, 1.0);
  tree.cells[0].density = 12;
  const Cell root = tree.cells[0];
  ASSERT_EQ(root.rank, 4);
  ASSERT_EQ(splitCell(tree, 0), 1);
  EXPECT_EQ(tree.cells[0].child, 1);
  const std::uint32_t half = sideOf(root) / 2;
  const std::uint32_t x[] = {0, half, 0, half}, y[] = {0, 0, half, half};  // SW, SE, NW, NE
  for (std::size_t k = 0; k < 4; ++k) {
    const Cell& child = tree.cells[1 + k];
    EXPECT_EQ(child.x, x[k]);
    EXPECT_EQ(child.y, y[k]);
    EXPECT_EQ(child.rank, 3);
    EXPECT_EQ(child.child, -1);
    EXPECT_EQ(child.density, 9) << "the coarsest that a cell of rank 3 may hold";
  }
  tree.cells[1].density = 5;
  const std::int32_t first = splitCell(tree, 1);
  EXPECT_EQ(cellAt(tree, first).density, 5);
}

TEST(LeafAt, IsTheLeafWhoseSquareHoldsThePoint) {
  Random random{41};
  for (int k = 0; k < 20; ++k) {
    const Quadtree tree = randomTree(random, 60);
    const Point corner = tree.corner(tree.cells[0]);
    const double side = tree.side(tree.cells[0]);
    for (int probe = 0; probe < 100; ++probe) {
      const Point p = corner + Point{random.between(0, side), random.between(0, side)};
      const Cell& leaf = cellAt(tree, leafAt(tree, p));
      EXPECT_EQ(leaf.child, -1);
      EXPECT_LE(tree.corner(leaf).x, p.x);
      EXPECT_LE(tree.corner(leaf).y, p.y);
      EXPECT_GE(tree.corner(leaf).x + tree.side(leaf), p.x);
      EXPECT_GE(tree.corner(leaf).y + tree.side(leaf), p.y);
    }
  }
}

TEST(LeafAt, GivesPointsOutsideToTheNearestLeaf) {
  Random random{42};
  const Quadtree tree = randomTree(random, 80);
  const Point corner = tree.corner(tree.cells[0]);
  const double side = tree.side(tree.cells[0]);
  for (int probe = 0; probe < 200; ++probe) {
    const Point p = corner + Point{random.between(-side, 2 * side), random.between(-side, 2 * side)};
    const double inside = side * (1.0 - 1e-9);
    const Point nearest =
        corner + Point{std::clamp(p.x - corner.x, 0.0, inside), std::clamp(p.y - corner.y, 0.0, inside)};
    EXPECT_EQ(leafAt(tree, p), leafAt(tree, nearest));
  }
  EXPECT_GE(leafAt(tree, {1e300, -1e300}), 0);
  EXPECT_GE(leafAt(tree, {NAN, 0}), 0);
}

TEST(NeighboursOf, AreTheLeavesThatShareASide) {
  Random random{43};
  for (int k = 0; k < 10; ++k) {
    const Quadtree tree = randomTree(random, 50);
    const std::vector<std::int32_t> leaves = leavesOf(tree);
    for (const std::int32_t leaf : leaves) {
      std::vector<std::int32_t> found{99};
      neighboursOf(tree, leaf, found);
      std::vector<std::int32_t> expected;
      for (const std::int32_t other : leaves) {
        if (other != leaf && shareASide(cellAt(tree, leaf), cellAt(tree, other))) expected.push_back(other);
      }
      std::ranges::sort(found);
      EXPECT_EQ(found, expected);
    }
  }
}

class TreeOf : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Domains, TreeOf,
                         testing::Values(support::kFrame, support::kCrackedFrame, support::kRound, support::kNotched));

TEST_P(TreeOf, IsBalancedAndHoldsEveryConstraint) {
  const MeshState state = support::after(support::domainFrom(GetParam()), Stage::quadtree);
  const Quadtree& tree = state.tree;
  std::vector<std::int32_t> around;
  for (const std::int32_t leaf : leavesOf(tree)) {
    neighboursOf(tree, leaf, around);
    for (const std::int32_t other : around) {
      EXPECT_LE(std::abs(cellAt(tree, leaf).rank - cellAt(tree, other).rank), 1) << "cells " << leaf << ", " << other;
    }
  }
  ASSERT_FALSE(state.constraints.empty());
  for (const Constraint& constraint : state.constraints) {
    const Cell& leaf = cellAt(tree, leafAt(tree, constraint.at));
    // At most the wish, but no finer than the finest rank.
    EXPECT_LE(tree.minEdge * rankLength(leaf.density), std::max(constraint.length, tree.minEdge) * (1 + 1e-9));
    EXPECT_LE(leaf.rank, largestCellRank(leaf.density));
  }
}

TEST_P(TreeOf, CoversTheRootOnce) {
  const MeshState state = support::after(support::domainFrom(GetParam()), Stage::density);
  double area = 0.0;
  for (const std::int32_t leaf : leavesOf(state.tree)) {
    area += std::pow(4.0, cellAt(state.tree, leaf).rank - 1);
  }
  EXPECT_EQ(area, std::pow(4.0, state.tree.cells[0].rank - 1));
  for (const Cell& cell : state.tree.cells) {
    if (cell.child < 0) continue;
    for (std::uint32_t k = 0; k < 4; ++k) {
      const Cell& child = cellAt(state.tree, cell.child + static_cast<std::int32_t>(k));
      EXPECT_EQ(child.rank + 1, cell.rank);
      EXPECT_EQ(child.x, cell.x + k % 2 * sideOf(child));
      EXPECT_EQ(child.y, cell.y + k / 2 * sideOf(child));
    }
  }
}

}  // namespace
}  // namespace triscope::quadtree_test
