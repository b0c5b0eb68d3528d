// What can be asked of a state before it has a tree.
#include "core/density/wanted.h"

#include <gtest/gtest.h>

#include "support/runs.h"

namespace triscope {
namespace {

TEST(Wanted, IsNothingBeforeThereIsATree) {
  const MeshState state = support::start(support::domainFrom(support::kFrame));
  EXPECT_FALSE(wantedAt(state.tree, {0.0, 0.0}));
  EXPECT_EQ(cellOf(state.tree, 0), nullptr);
}

TEST(Wanted, IsWhatTheTreeSays) {
  const MeshState state = support::after(support::domainFrom(support::kFrame), Stage::density);
  for (const Point p : {Point{0.0, 0.0}, {7.9, -7.9}, {1e6, 0.0}}) {
    const std::optional<Wanted> wanted = wantedAt(state.tree, p);
    ASSERT_TRUE(wanted);
    EXPECT_EQ(wanted->length, edgeLengthAt(state.tree, p));
    EXPECT_EQ(wanted->rank, densityRankAt(state.tree, p));
    EXPECT_EQ(wanted->cell, leafAt(state.tree, p));
  }
  EXPECT_EQ(cellOf(state.tree, 0), &state.tree.cells[0]);
  EXPECT_EQ(cellOf(state.tree, -1), nullptr);
  EXPECT_EQ(cellOf(state.tree, static_cast<std::int64_t>(state.tree.cells.size())), nullptr);
}

}  // namespace
}  // namespace triscope
