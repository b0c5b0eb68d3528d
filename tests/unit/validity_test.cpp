// Each rule of validity, on a good mesh and on one spoilt by hand.
#include "core/run/validity.h"

#include <gtest/gtest.h>

#include "core/mesh/edit.h"
#include "support/domains.h"
#include "support/meshes.h"
#include "support/runs.h"

namespace triscope::validity_test {
namespace {

Event endOf(Stage stage) {
  Event event;
  event.kind = EventKind::stage_finished;
  event.stage = stage;
  return event;
}

int brokenAfter(const MeshState& state, Stage stage) {
  const Event end = endOf(stage);
  return brokenRules(state, support::liveSlots(state.mesh), {&end, 1}, shortestInput(state));
}

class Validity : public testing::TestWithParam<const char*> {
 protected:
  MeshState state = support::after(support::domainFrom(GetParam()), Stage::step5);
};

INSTANTIATE_TEST_SUITE_P(Domains, Validity,
                         testing::Values(support::kFrame, support::kCrackedFrame, support::kRound, support::kNotched));

TEST_P(Validity, NothingIsBrokenInAGoodMesh) {
  EXPECT_EQ(brokenAfter(state, Stage::step5), 0);
  EXPECT_EQ(brokenAfter(state, Stage::density), 0);
}

TEST_P(Validity, AMovedPointTurnsATriangleOver) {
  const Vertex vertex = state.front1.front();
  state.mesh.points[vertex] = state.mesh.points[vertex] + Point{100.0, 0.0};
  EXPECT_NE(brokenAfter(state, Stage::step5) & kOrientation, 0);
}

TEST_P(Validity, AMovedPointUndoesTheDelaunayProperty) {
  const Vertex vertex = state.front1.front();
  const double h = state.minEdge;
  int broken = 0;
  for (int k = 0; k < 40 && (broken & (kDelaunay | kOrientation)) == 0; ++k) {
    state.mesh.points[vertex] = state.mesh.points[vertex] + Point{0.05 * h, 0.03 * h};
    broken = brokenAfter(state, Stage::step5);
  }
  EXPECT_NE(broken & kDelaunay, 0);
}

TEST_P(Validity, ABoundaryEdgeIsMissed) {
  // Said to go on to a vertex that its first is not joined to.
  BoundaryEdge& edge = state.mesh.edges.front();
  edge.v1 = state.front2.back();
  EXPECT_NE(brokenAfter(state, Stage::step5) & kBoundary, 0);
}

TEST_P(Validity, ATriangleTakenOutLeavesAGap) {
  killTriangle(state.mesh, support::liveSlots(state.mesh).front());
  const Event end = endOf(Stage::step5);
  EXPECT_EQ(brokenRules(state, {}, {&end, 1}, shortestInput(state)), kArea);
  EXPECT_EQ(brokenRules(state, {}, {}, shortestInput(state)), 0) << "only where a stage ends";
}

TEST(ValidityOfTheQuadtree, ACellSplitTwiceIsOutOfBalance) {
  MeshState state = support::after(support::domainFrom(support::kNotched), Stage::density);
  std::int32_t largest = -1;
  for (std::size_t k = 0; k < state.tree.cells.size(); ++k) {
    const Cell& cell = state.tree.cells[k];
    if (cell.child < 0 && (largest < 0 || cell.rank > state.tree.cells[static_cast<std::size_t>(largest)].rank))
      largest = static_cast<std::int32_t>(k);
  }
  ASSERT_GE(state.tree.cells[static_cast<std::size_t>(largest)].rank, 3);
  EXPECT_EQ(brokenAfter(state, Stage::density), 0);
  splitCell(state.tree, splitCell(state.tree, largest));
  EXPECT_EQ(brokenAfter(state, Stage::density), kBalance);
}

TEST_P(Validity, AnEdgeIsTooShort) {
  state.minEdge *= 100.0;
  EXPECT_EQ(brokenRules(state, support::liveSlots(state.mesh), {}, 1e300), kMinimumLength);
}

}  // namespace
}  // namespace triscope::validity_test
