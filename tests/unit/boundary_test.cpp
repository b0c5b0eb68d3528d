// Boundary points (paper, section 3, Figure 4 a), their triangulation, and the recovery of the boundary's edges.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/mesh/edit.h"
#include "support/ids.h"
#include "support/judge.h"
#include "support/meshes.h"
#include "support/runs.h"
#include "support/watch.h"

namespace triscope::boundary_test {
namespace {

using support::operator""_v;

// ∫ ds / h from t0 to t1, by many short steps: independent of the stage's own.
double integral(const MeshState& state, const Curve& curve, double t0, double t1) {
  constexpr int kSteps = 2000;
  double sum = 0.0;
  for (int k = 0; k < kSteps; ++k) {
    const double t = t0 + (t1 - t0) * (k + 0.5) / kSteps;
    sum += length(derivativeAt(curve, t)) * (t1 - t0) / kSteps / edgeLengthAt(state.tree, pointAt(curve, t));
  }
  return sum;
}

// The boundary points of each curve, in order.
std::vector<std::vector<BoundaryPoint>> byCurve(const MeshState& state) {
  std::vector<std::vector<BoundaryPoint>> runs(state.domain->curves.size());
  for (const BoundaryPoint& point : state.boundary) runs[point.curve].push_back(point);
  return runs;
}

class BoundaryOf : public testing::TestWithParam<const char*> {
 protected:
  MeshState state = support::after(support::domainFrom(GetParam()), Stage::boundary);
};

INSTANTIATE_TEST_SUITE_P(Domains, BoundaryOf,
                         testing::Values(support::kFrame, support::kCrackedFrame, support::kRound, support::kNotched));

TEST_P(BoundaryOf, KeepsTheEndsOfEveryCurve) {
  const auto runs = byCurve(state);
  for (std::size_t c = 0; c < runs.size(); ++c) {
    const Curve& curve = state.domain->curves[c];
    ASSERT_GE(runs[c].size(), 2u);
    EXPECT_EQ(runs[c].front().at, curve.a);
    EXPECT_EQ(runs[c].back().at, curve.b);
    EXPECT_EQ(runs[c].front().t, 0.0);
    EXPECT_EQ(runs[c].back().t, 1.0);
    for (std::size_t k = 0; k < runs[c].size(); ++k) {
      EXPECT_EQ(runs[c][k].kept, k == 0 || k + 1 == runs[c].size());
      EXPECT_EQ(runs[c][k].at, k == 0 ? curve.a : k + 1 == runs[c].size() ? curve.b : pointAt(curve, runs[c][k].t));
      if (k > 0) {
        EXPECT_GT(runs[c][k].t, runs[c][k - 1].t);
      }
    }
  }
}

TEST_P(BoundaryOf, EveryEdgeSeesTheSameIntegral) {
  const auto runs = byCurve(state);
  for (std::size_t c = 0; c < runs.size(); ++c) {
    const Curve& curve = state.domain->curves[c];
    const double whole = integral(state, curve, 0.0, 1.0);
    const auto edges = static_cast<double>(runs[c].size() - 1);
    for (std::size_t k = 1; k < runs[c].size(); ++k) {
      // h jumps at the cells' sides: a trapezoid that spans a jump is off by a part of a quarter edge.
      EXPECT_NEAR(integral(state, curve, runs[c][k - 1].t, runs[c][k].t), whole / edges, 0.12 * whole / edges + 0.05)
          << "curve " << c << ", edge " << k;
    }
  }
}

TEST_P(BoundaryOf, EveryCurveHasAsManyEdgesAsItsIntegralAsksFor) {
  const auto runs = byCurve(state);
  for (const Loop& loop : state.domain->loops) {
    for (std::uint32_t c = loop.firstCurve; c < loop.firstCurve + loop.curveCount; ++c) {
      const double whole = integral(state, state.domain->curves[c], 0.0, 1.0);
      const auto edges = static_cast<double>(runs[c].size() - 1);
      EXPECT_LE(edges, std::max(whole + 0.6, loop.curveCount == 1 ? 6.0 : 3.0)) << "curve " << c;
      double shortest = 1e300;
      for (std::size_t k = 1; k < runs[c].size(); ++k) {
        shortest = std::min(shortest, distance(runs[c][k - 1].at, runs[c][k].at));
      }
      // Fewer only where one more would make an edge shorter than Δx.
      if (edges < whole - 0.6) {
        EXPECT_LT(shortest * edges / (edges + 1.0), state.minEdge) << "curve " << c;
      }
    }
  }
}

TEST_P(BoundaryOf, NoEdgeIsShorterThanDx) {
  const double floor = std::min(state.minEdge, support::shortestUnavoidableEdge(*state.domain));
  const auto runs = byCurve(state);
  for (const auto& run : runs) {
    for (std::size_t k = 1; k < run.size(); ++k) {
      EXPECT_GE(distance(run[k - 1].at, run[k].at), floor * (1 - 1e-9));
    }
  }
}

TEST_P(BoundaryOf, EventsShowEachPointOnce) {
  MeshState fresh = support::start(support::domainFrom(GetParam()));
  std::vector<Event> events;
  Journal journal{&events};
  while (advanceUntil(fresh, Stage::boundary, 1000, journal)) {
  }
  std::erase_if(events, [](const Event& e) { return e.kind != EventKind::boundary_point; });
  ASSERT_EQ(events.size(), state.boundary.size());
  for (std::size_t k = 0; k < events.size(); ++k) {
    EXPECT_EQ(events[k].other, k);
    EXPECT_EQ(events[k].subject, state.boundary[k].curve);
    EXPECT_EQ(events[k].at, state.boundary[k].at);
    EXPECT_EQ(events[k].measured, edgeLengthAt(state.tree, state.boundary[k].at));
  }
}

TEST_P(BoundaryOf, TriangulationHasEveryPointOnceAndIsDelaunay) {
  support::runPast(state, Stage::triangulation);
  const Mesh& mesh = state.mesh;
  for (const BoundaryPoint& point : state.boundary) {
    ASSERT_GE(point.vertex, 4_v);
    EXPECT_EQ(pointOf(mesh, point.vertex), point.at);
    EXPECT_EQ(mesh.kinds[point.vertex], point.kept ? VertexKind::kept : VertexKind::boundary);
  }
  for (const Vertex v : {0_v, 1_v, 2_v, 3_v}) EXPECT_EQ(mesh.kinds[v], VertexKind::helper);
  EXPECT_EQ(mesh.liveCount(), 2 * (mesh.points.size() - 4) + 2);
  if (mesh.points.size() < 150) support::expectDelaunayByBruteForce(mesh);
}

TEST_P(BoundaryOf, RecoveryMakesEveryEdgePresent) {
  support::runPast(state, Stage::recovery);
  for (const BoundaryEdge& edge : state.mesh.edges) {
    EXPECT_TRUE(findHalfEdge(state.mesh, edge.v0, edge.v1).exists());
    EXPECT_TRUE(findHalfEdge(state.mesh, edge.v1, edge.v0).exists());
  }
}

TEST_P(BoundaryOf, CarveLeavesTheDomainAlone) {
  support::runPast(state, Stage::recovery);
  const TriangleId nextId = state.mesh.nextId;
  support::runPast(state, Stage::carve);
  EXPECT_EQ(state.mesh.nextId, nextId) << "carving makes no triangle";
  for (const Vertex v : {0_v, 1_v, 2_v, 3_v}) EXPECT_EQ(state.mesh.kinds[v], VertexKind::removed);
  support::expectValid(state.mesh);
  support::expectFollowsDomain(state);
}

// Without the gap rule, points of one side of a channel lie in the circles over the other side's edges.
TEST(Recovery, SplitsWhatTheTriangulationLacks) {
  Settings settings;
  settings.gapFraction = 10.0;
  MeshState state = support::start(support::domainFrom(R"({"min_edge_length": 0.2,
    "outer": [[0, 0], [20, 0], [20, 20], [0, 20]], "holes": [[[3.1, 0.3], [17.3, 0.3], [17.3, 8], [3.1, 8]]]})"),
                                   settings);
  std::vector<Event> events;
  Journal journal{&events};
  while (advanceUntil(state, Stage::recovery, 1000, journal)) {
  }
  const auto split = std::ranges::count(events, EventKind::edge_split, &Event::kind);
  EXPECT_GT(split, 0) << "the domain no longer needs recovery";
  for (const Event& event : events) {
    if (event.kind != EventKind::edge_split) continue;
    EXPECT_EQ(event.rule, Rule::recover_edge);
    EXPECT_EQ(state.mesh.kinds[Vertex(event.vertex)], VertexKind::split);
    EXPECT_EQ(state.mesh.points[Vertex(event.vertex)], event.at);
  }
  for (const BoundaryEdge& edge : state.mesh.edges) EXPECT_TRUE(findHalfEdge(state.mesh, edge.v0, edge.v1).exists());
  support::runPast(state, Stage::carve);
  support::expectValid(state.mesh);
  support::expectFollowsDomain(state);
}

}  // namespace
}  // namespace triscope::boundary_test
