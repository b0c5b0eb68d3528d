// Step 6 (paper, section 4): what may move, why it moved or stayed, and that no bound is given up.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/geometry/predicates.h"
#include "core/mesh/badness.h"
#include "core/mesh/edit.h"
#include "core/quality/quality.h"
#include "core/words/vocabulary.h"
#include "support/judge.h"
#include "support/meshes.h"
#include "support/runs.h"
#include "support/watch.h"

namespace triscope::refine_test {
namespace {

constexpr const char* kSquare = R"({"outer": [[0, 0], [8, 0], [8, 8], [0, 8]], "min_edge_length": 0.3,
  "density": [{"at": [3, 5], "rank": 1}]})";

Settings only(bool Settings::* part) {
  Settings settings = support::withoutStep6();
  settings.*part = true;
  return settings;
}

bool insideStar(const Mesh& mesh, Vertex vertex, Point to) {
  Star star;
  starOf(mesh, vertex, star);
  return star.closed && std::ranges::all_of(star.rim, [&](Half rim) {
           return orient2d(pointOf(mesh, startOf(mesh, rim)), pointOf(mesh, endOf(mesh, rim)), to) > 0;
         });
}

class Refine : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Domains, Refine, testing::Values(kSquare, support::kCrackedFrame, support::kRound));

TEST_P(Refine, EveryMoveIsWhatItsEventSays) {
  MeshState state = support::after(support::domainFrom(GetParam()), Stage::step5);
  ASSERT_EQ(state.stage, Stage::refine);
  int moved = 0, refused = 0;
  support::eachDecision(state, Stage::refine, [&](const MeshState& before, const MeshState& now, auto events) {
    if (events.empty()) return;
    ASSERT_EQ(events.size(), 1u);
    const Event& event = events.front();
    const Vertex vertex(event.vertex);
    EXPECT_EQ(before.mesh.vertexEdge[vertex], EdgeId()) << "a boundary vertex may not move";
    EXPECT_EQ(event.from, pointOf(before.mesh, vertex));
    EXPECT_EQ(now.mesh.points.size(), before.mesh.points.size());
    if (event.kind == EventKind::vertex_moved) {
      ++moved;
      EXPECT_EQ(pointOf(now.mesh, vertex), event.at);
      EXPECT_TRUE(insideStar(before.mesh, vertex, event.at));
      // Nowhere has the mesh got worse in what the method promises.
      const Badness was = badnessOf(before.mesh, support::liveSlots(before.mesh));
      const Badness is = badnessOf(now.mesh, support::liveSlots(now.mesh));
      EXPECT_LE(is.broken, was.broken);
      EXPECT_LE(is.obtuse, was.obtuse);
    } else {
      ASSERT_EQ(event.kind, EventKind::vertex_kept);
      ++refused;
      Mesh kept = now.mesh;
      kept.tested = before.mesh.tested;  // what was seen on the way to the move is remembered
      EXPECT_EQ(support::difference(kept, before.mesh), "") << "a refused move changed the mesh";
      switch (event.refusal) {
        case Refusal::inverts_triangle:
          EXPECT_FALSE(insideStar(before.mesh, vertex, event.at));
          break;
        case Refusal::edge_below_minimum:
          EXPECT_LT(event.measured, event.limit);
          EXPECT_EQ(event.limit, state.tree.minEdge);
          break;
        case Refusal::bound_broken:
        case Refusal::star_worse:
          EXPECT_TRUE(insideStar(before.mesh, vertex, event.at));
          break;
        default:
          ADD_FAILURE() << "step 6 cannot refuse for '" << name(event.refusal) << "'";
      }
    }
  });
  EXPECT_GT(moved, 100);
  EXPECT_GT(refused, 10);
}

TEST_P(Refine, BoundaryStaysWhereItIs) {
  MeshState state = support::after(support::domainFrom(GetParam()), Stage::step5);
  const MeshState before = state;
  support::runPast(state, Stage::refine);
  for (const Vertex v : before.mesh.points.keys()) {
    if (before.mesh.vertexEdge[v].exists()) {
      EXPECT_EQ(state.mesh.points[v], before.mesh.points[v]);
    }
  }
  EXPECT_EQ(state.mesh.edges.size(), before.mesh.edges.size());
  EXPECT_EQ(state.mesh.liveCount(), before.mesh.liveCount());
}

TEST_P(Refine, LeavesFewerObtuseTriangles) {
  MeshState state = support::after(support::domainFrom(GetParam()), Stage::step5);
  const Quality before = measure(state.mesh);
  support::runPast(state, Stage::refine);
  const Quality after = measure(state.mesh);
  EXPECT_LT(after.obtuse, before.obtuse / 4 + 2);
  EXPECT_LT(after.areaRatioMax, before.areaRatioMax);
  EXPECT_LT(after.edgeRatioMax, before.edgeRatioMax);
  EXPECT_LE(after.aspectMax, before.aspectMax * (1 + 1e-9));
  support::expectBounds(state);
}

TEST_P(Refine, EachPartAloneKeepsTheBounds) {
  for (bool Settings::* const part :
       {&Settings::laplacian, &Settings::reduceObtuse, &Settings::sharedEdge, &Settings::polish}) {
    const Settings settings = only(part);
    std::vector<Event> events;
    Journal journal{&events};
    MeshState state = support::start(support::domainFrom(GetParam()), settings);
    while (advance(state, Grain::all, journal)) {
    }
    support::expectBounds(state);
    support::expectValid(state.mesh);
    const Rule rule = part == &Settings::laplacian      ? Rule::laplacian
                      : part == &Settings::reduceObtuse ? Rule::reduce_obtuse
                      : part == &Settings::sharedEdge   ? Rule::shared_edge
                                                        : Rule::polish;
    for (const Event& event : events) {
      if (event.stage == Stage::refine && !support::aboutAStage(event)) {
        EXPECT_EQ(event.rule, rule);
      }
    }
  }
}

// p0 + part · Σ (pi - p0) / n, the filter of the paper, as far as 24 passes of it go with the neighbours at rest.
TEST(Laplacian, MovesTowardTheMeanOfTheNeighbours) {
  for (const double omega : {0.05, 0.25}) {
    Settings settings = only(&Settings::laplacian);
    settings.omega = omega;
    settings.refinePasses = 1;
    MeshState state = support::after(support::domainFrom(kSquare), Stage::step5, settings);
    int looked = 0;
    support::eachDecision(state, Stage::refine, [&](const MeshState& before, const MeshState&, auto events) {
      if (events.empty()) return;
      const Event& event = events.front();
      Star star;
      starOf(before.mesh, Vertex(event.vertex), star);
      Point mean;
      for (const Half rim : star.rim) mean = mean + pointOf(before.mesh, startOf(before.mesh, rim));
      mean = (1.0 / static_cast<double>(star.rim.size())) * mean;
      const Point expected = event.from + (1.0 - std::pow(1.0 - omega, 24)) * (mean - event.from);
      EXPECT_LT(distance(event.at, expected), 1e-12);
      ++looked;
    });
    EXPECT_GT(looked, 50);
  }
}

TEST(RefinePasses, StopAtTheirBudget) {
  Settings settings;
  settings.refinePasses = 2;
  MeshState state = support::start(support::domainFrom(kSquare), settings);
  std::vector<Event> events;
  Journal journal{&events};
  while (advance(state, Grain::all, journal)) {
  }
  for (const Event& event : events) {
    if (event.stage == Stage::refine && !support::aboutAStage(event)) {
      EXPECT_LE(event.round, 2);
    }
  }
}

}  // namespace
}  // namespace triscope::refine_test
