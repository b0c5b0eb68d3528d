// Any sequence of edits, in a domain with holes, chains and bent curves, leaves a valid mesh.
#include "core/mesh/mesh.h"

#include <gtest/gtest.h>

#include "support/edits.h"
#include "support/ids.h"
#include "support/judge.h"
#include "support/runs.h"

namespace triscope::mesh_test {
namespace {

using support::operator""_edge;

TEST(Edits, AnySequenceLeavesAValidMesh) {
  for (const char* const json : {support::kFrame, support::kCrackedFrame, support::kRound}) {
    const MeshState start = support::after(support::domainFrom(json), Stage::front1);
    support::EditCounts counts;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      SCOPED_TRACE("seed " + std::to_string(seed) + " on " + start.domain->name);
      MeshState state = start;
      support::Random random{seed};
      for (int k = 0; k < 200; ++k) {
        const std::string edit = support::editAtRandom(state, random, counts);
        if (k % 20 != 19) continue;
        support::expectValid(state.mesh);
        ASSERT_FALSE(HasFailure()) << "after edit " << k << ", " << edit;
      }
      support::expectFollowsDomain(state);
    }
    for (const int count : {counts.inserted, counts.moved, counts.removed, counts.split}) EXPECT_GT(count, 20);
  }
}

// Edges between boundary vertices: each is in both lists, however often it was split.
TEST(BoundaryLists, FollowSplits) {
  const MeshState start = support::after(support::domainFrom(support::kCrackedFrame), Stage::carve);
  MeshState state = start;
  support::Random random{5};
  for (int k = 0; k < 60; ++k) {
    const EdgeId e(random.below(state.mesh.edges.size()));
    const Attempt attempt = splitBoundary(state.mesh, *state.domain, state.tree, e, 0.0, state.room.placing);
    ASSERT_TRUE(attempt.vertex.exists());
    EXPECT_EQ(findBoundaryEdge(state.mesh, state.mesh.edges[e].v0, attempt.vertex), e);
  }
  EXPECT_EQ(state.mesh.edges.size(), start.mesh.edges.size() + 60);
  for (const EdgeId e : state.mesh.edges.keys()) {
    const BoundaryEdge& edge = state.mesh.edges[e];
    EXPECT_EQ(findBoundaryEdge(state.mesh, edge.v0, edge.v1), e);
    EXPECT_EQ(findBoundaryEdge(state.mesh, edge.v1, edge.v0), e);
  }
  EXPECT_EQ(findBoundaryEdge(state.mesh, state.mesh.edges[0_edge].v0, state.mesh.edges[0_edge].v0), EdgeId());
  support::expectFollowsDomain(state);
}

TEST(FindHalfEdge, FindsEveryEdgeInItsDirection) {
  const MeshState state = support::after(support::domainFrom(support::kCrackedFrame), Stage::step1);
  for (const Half half : halvesOf(state.mesh)) {
    if (!state.mesh.alive(triangleOf(half))) continue;
    const Vertex a = startOf(state.mesh, half), b = endOf(state.mesh, half);
    EXPECT_EQ(findHalfEdge(state.mesh, a, b), half);
    EXPECT_EQ(findHalfEdge(state.mesh, b, a), oppositeOf(state.mesh, half));
  }
}

TEST(StarOf, GoesAroundOnce) {
  const MeshState state = support::after(support::domainFrom(support::kCrackedFrame), Stage::step1);
  Per<Vertex, std::size_t> degree(state.mesh.points.size(), 0);
  for (const Slot slot : state.mesh.triangles.keys()) {
    if (!state.mesh.alive(slot)) continue;
    for (const Vertex v : state.mesh.triangles[slot].v) ++degree[v];
  }
  Star star;
  for (const Vertex v : degree.keys()) {
    starOf(state.mesh, v, star);
    ASSERT_EQ(star.rim.size(), degree[v]);
    for (std::size_t k = 0; k < star.rim.size(); ++k) {
      EXPECT_EQ(apexOf(state.mesh, star.rim[k]), v);
      if (k + 1 < star.rim.size() || star.closed) {
        EXPECT_EQ(endOf(state.mesh, star.rim[k]), startOf(state.mesh, star.rim[(k + 1) % star.rim.size()]));
      }
    }
  }
}

}  // namespace
}  // namespace triscope::mesh_test
