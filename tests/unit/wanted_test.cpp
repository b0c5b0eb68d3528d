// What can be asked of a state before it has a tree.
#include "core/density/wanted.h"

#include <gtest/gtest.h>

#include "support/optimised.h"
#include "support/runs.h"

namespace triscope::wanted_test {
namespace {

TEST(Wanted, IsNothingBeforeThereIsATree) {
  const MeshState state = support::start(support::domainFrom(support::kFrame));
  EXPECT_FALSE(wantedAt(state.tree, {0.0, 0.0}));
  EXPECT_EQ(cellOf(state.tree, 0), nullptr);
}

TEST(Wanted, IsWhatTheTreeSays) {
  const MeshState state = support::after(support::domainFrom(support::kFrame), Stage::density);
  const MeshState smooth = support::after(support::domainFrom(support::kFrame), Stage::density, support::best());
  ASSERT_FALSE(smooth.tree.corners.empty());
  for (const Quadtree* const tree : {&state.tree, &smooth.tree}) {
    for (const Point p : {Point{0.0, 0.0}, {7.9, -7.9}, {2.3, 4.1}, {1e6, 0.0}}) {
      const std::optional<Wanted> wanted = wantedAt(*tree, p);
      ASSERT_TRUE(wanted);
      EXPECT_EQ(wanted->length, edgeLengthAt(*tree, p));
      EXPECT_EQ(wanted->rank, densityRankAt(*tree, p));
      EXPECT_EQ(wanted->cell, leafAt(*tree, p));
    }
  }
  EXPECT_EQ(cellOf(state.tree, 0), &state.tree.cells[0]);
  EXPECT_EQ(cellOf(state.tree, -1), nullptr);
  EXPECT_EQ(cellOf(state.tree, static_cast<std::int64_t>(state.tree.cells.size())), nullptr);
}

/// A step of 0.2 halves the length of rank 1 once; the Δx in force stays as it was given.
TEST(EdgeLengthOf, IsTheTreesFromTheStartOfTheRun) {
  MeshState state = support::start(support::domainFrom(
      R"({"min_edge_length": 0.5, "outer": [[0, 0], [8, 0], [8, 8], [7, 8], [7, 7.8], [0, 7.8]]})"));
  ASSERT_TRUE(state.tree.cells.empty());
  EXPECT_EQ(state.minEdge, 0.5);
  EXPECT_EQ(edgeLengthOf(state.tree, 1), 0.25);
  EXPECT_EQ(edgeLengthOf(state.tree, 4), 0.5);
  Journal nobody;
  advanceUntil(state, Stage::density, ~0ull, nobody);
  EXPECT_EQ(edgeLengthOf(state.tree, 1), 0.25);
  EXPECT_EQ(wantedAt(state.tree, {7.0, 7.9})->length, edgeLengthOf(state.tree, wantedAt(state.tree, {7.0, 7.9})->rank));
}

}  // namespace
}  // namespace triscope::wanted_test
