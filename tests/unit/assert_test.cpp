// A broken invariant ends the program and says in words which, where; heavy checks only where they are asked for.
#include "core/base/assert.h"

#include <gtest/gtest.h>

#include "core/mesh/cavity.h"
#include "core/mesh/edit.h"
#include "core/mesh/flip.h"
#include "core/run/breakpoint.h"
#include "core/run/event_log.h"
#include "core/run/history.h"
#include "support/runs.h"

namespace triscope {
namespace {

Mesh oneTriangle() {
  Mesh mesh;
  for (const Point p : {Point{0, 0}, Point{1, 0}, Point{0, 1}}) addVertex(mesh, p, VertexKind::kept, 1);
  addTriangle(mesh, 0, 1, 2);
  return mesh;
}

TEST(AssertDeathTest, ABrokenInvariantIsSaidInWords) {
  Mesh mesh = oneTriangle();
  killTriangle(mesh, 0);
  EXPECT_EXIT(killTriangle(mesh, 0), testing::KilledBySignal(SIGABRT),
              "^edit\\.cpp:[0-9]+: a broken invariant, mesh\\.alive\\(slot\\): a triangle is removed once\n"
              "This is a defect of the program: please report it\\.\n$");
}

TEST(AssertDeathTest, EditsOfAMeshHoldTheirOwn) {
  Mesh mesh = oneTriangle();
  EXPECT_DEATH(addTriangle(mesh, 0, 1, 1), "a triangle has three corners");
  EXPECT_DEATH(flipEdge(mesh, 0), "an edge of the boundary is never flipped");
  EXPECT_DEATH(addBoundaryEdge(mesh, {.v0 = 1, .v1 = 1}), "a boundary edge has two ends");
  addBoundaryEdge(mesh, {.v0 = 0, .v1 = 1});
  mesh.vertexEdge[1] = -1;
  EXPECT_DEATH(splitBoundaryEdge(mesh, 0, 2, 0.5), "a boundary edge is in the lists of both its ends");
  mesh.freeSlots.push_back(0);
  EXPECT_DEATH(takeSlot(mesh), "a free slot holds no triangle");
  Cavity cavity;
  findCavity(mesh, {0.2, 0.2}, 0, cavity);
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
    state.mesh.nextId = 0;
    EXPECT_DEATH(support::runPast(state, Stage::step1), "after step 1 triangle .*: its id is not below the next one");
  }
}

}  // namespace
}  // namespace triscope
