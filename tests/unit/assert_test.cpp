// A broken invariant ends the program and says in words which, where; heavy checks only where they are asked for.
#include "core/base/assert.h"

#include <gtest/gtest.h>

#include "core/mesh/cavity.h"
#include "core/mesh/edit.h"
#include "core/mesh/flip.h"
#include "core/run/breakpoint.h"
#include "core/run/event_log.h"
#include "core/run/history.h"
#include "support/ids.h"
#include "support/runs.h"

namespace triscope::assert_test {
namespace {

using support::operator""_edge, support::operator""_half, support::operator""_id, support::operator""_slot,
    support::operator""_v;

Mesh oneTriangle() {
  Mesh mesh;
  for (const Point p : {Point{0, 0}, Point{1, 0}, Point{0, 1}}) addVertex(mesh, p, VertexKind::kept, 1);
  addTriangle(mesh, 0_v, 1_v, 2_v);
  return mesh;
}

TEST(AssertDeathTest, ABrokenInvariantIsSaidInWords) {
  Mesh mesh = oneTriangle();
  killTriangle(mesh, 0_slot);
  EXPECT_EXIT(killTriangle(mesh, 0_slot), testing::KilledBySignal(SIGABRT),
              "^edit\\.cpp:[0-9]+: a broken invariant, mesh\\.alive\\(slot\\): a triangle is removed once\n"
              "This is a defect of the program: please report it\\.\n$");
}

TEST(AssertDeathTest, EditsOfAMeshHoldTheirOwn) {
  Mesh mesh = oneTriangle();
  EXPECT_DEATH(addTriangle(mesh, 0_v, 1_v, 1_v), "a triangle has three corners");
  EXPECT_DEATH(flipEdge(mesh, 0_half), "an edge of the boundary is never flipped");
  EXPECT_DEATH(addBoundaryEdge(mesh, support::boundaryEdge(1_v, 1_v)), "a boundary edge has two ends");
  addBoundaryEdge(mesh, support::boundaryEdge(0_v, 1_v));
  mesh.vertexEdge[1_v] = {};
  EXPECT_DEATH(splitBoundaryEdge(mesh, 0_edge, 2_v, 0.5), "a boundary edge is in the lists of both its ends");
  mesh.freeSlots.push_back(0_slot);
  EXPECT_DEATH(takeSlot(mesh), "a free slot holds no triangle");
  Cavity cavity;
  findCavity(mesh, {0.2, 0.2}, 0_slot, cavity);
  cavity.rimCount = cavity.triangleCount;
  EXPECT_DEATH(fillCavity(mesh, cavity, VertexKind::steiner, 1), "a cavity has one or two edges around it more");
}

TEST(AssertDeathTest, WhatIsRememberedOfARunHoldsItsOwn) {
  EventLog log;
  EXPECT_DEATH((void)log[0], "an event that is read has been made");
  EXPECT_DEATH(log.truncate(1), "no more events are kept than there are");
  History history;
  EXPECT_DEATH((void)history.before(0), "a history is begun before it is read");
  Watch watch(support::start(support::domainFrom(support::kRound)), 0, {});
  MeshState state = support::start(support::domainFrom(support::kRound));
  std::vector<Hit> hits;
  EXPECT_DEATH(watch.step(state, violationBreakpoints(), hits), "the breakpoints that are watched for stay the same");
}

TEST(AssertDeathTest, WithHeavyChecksTheLibraryMindsItsIndices) {
  if constexpr (kHeavyChecks) {
    const std::vector<int> three(3);
    volatile std::size_t beyond = 3;
    EXPECT_DEATH((void)three[beyond], "Assertion");
  }
}

TEST(AssertDeathTest, HeavyChecksAreMadeWhereTheyAreAskedFor) {
  bool made = false;
  TRISCOPE_DCHECK(made = true, "what is assigned is true");
  EXPECT_EQ(made, kHeavyChecks);
  if constexpr (kHeavyChecks) {
    MeshState state = support::after(support::domainFrom(support::kRound), Stage::front2);
    Journal nobody;
    ASSERT_TRUE(advance(state, Grain::insertion, nobody));
    state.mesh.nextId = 0_id;
    EXPECT_DEATH(support::runPast(state, Stage::step1), "after step 1 triangle .*: its id is not below the next one");
  }
}

}  // namespace
}  // namespace triscope::assert_test
