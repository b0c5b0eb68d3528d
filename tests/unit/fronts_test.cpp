// The two fronts of points off the boundary (paper, section 3, Figure 4 c).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/mesh/edit.h"
#include "core/words/vocabulary.h"
#include "support/judge.h"
#include "support/meshes.h"
#include "support/runs.h"
#include "support/watch.h"

namespace triscope::fronts_test {
namespace {

double nearestVertex(const Mesh& mesh, Point p) {
  double nearest = INFINITY;
  for (const Vertex v : mesh.points.keys()) {
    if (mesh.vertexTriangle[v].exists()) nearest = std::min(nearest, distance(mesh.points[v], p));
  }
  return nearest;
}

bool inADiametralCircle(const Mesh& mesh, Point p) {
  return std::ranges::any_of(mesh.edges, [&](const BoundaryEdge& edge) {
    return dot(pointOf(mesh, edge.v0) - p, pointOf(mesh, edge.v1) - p) < 0.0;
  });
}

class FrontsOf : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Domains, FrontsOf,
                         testing::Values(support::kFrame, support::kCrackedFrame, support::kRound, support::kNotched));

TEST_P(FrontsOf, EveryPointKeepsItsDistance) {
  MeshState state = support::after(support::domainFrom(GetParam()), Stage::carve);
  int placed = 0;
  support::eachDecision(state, Stage::front2, [&](const MeshState& before, const MeshState& now, auto events) {
    if (events.empty() || events.front().stage > Stage::front2) return;
    ASSERT_EQ(events.size(), 1u);
    const Event& event = events.front();
    const double needed = std::max(0.7 * edgeLengthAt(before.tree, event.at), before.minEdge * (1 - 1e-9));
    EXPECT_LT(event.other, before.mesh.points.size()) << "the vertex that it stands at";
    if (event.kind == EventKind::vertex_inserted) {
      ++placed;
      EXPECT_GE(nearestVertex(before.mesh, event.at), needed * (1 - 1e-12));
      EXPECT_FALSE(inADiametralCircle(before.mesh, event.at)) << event.at.x << ", " << event.at.y;
      EXPECT_EQ(now.mesh.kinds[Vertex(event.vertex)],
                event.stage == Stage::front1 ? VertexKind::front1 : VertexKind::front2);
      return;
    }
    switch (event.refusal) {
      case Refusal::too_close:
        EXPECT_LT(event.measured, event.limit);
        EXPECT_DOUBLE_EQ(event.limit, needed);
        EXPECT_LE(nearestVertex(before.mesh, event.at), event.measured * (1 + 1e-12));
        break;
      case Refusal::encroaches_boundary:
        EXPECT_TRUE(inADiametralCircle(before.mesh, event.at));
        break;
      case Refusal::outside_domain:
        break;
      default:
        ADD_FAILURE() << "a front cannot refuse for '" << name(event.refusal) << "'";
    }
  });
  EXPECT_GT(placed, 20);
  support::expectValid(state.mesh);
}

TEST_P(FrontsOf, ListTheVerticesPlaced) {
  const MeshState state = support::after(support::domainFrom(GetParam()), Stage::front2);
  for (const Vertex v : state.mesh.points.keys()) {
    EXPECT_EQ(state.mesh.kinds[v] == VertexKind::front1, std::ranges::count(state.front1, v) == 1);
    EXPECT_EQ(state.mesh.kinds[v] == VertexKind::front2, std::ranges::count(state.front2, v) == 1);
  }
  // The first front is a set of closed loops of its own vertices.
  ASSERT_FALSE(state.frontLoops.empty());
  EXPECT_EQ(state.frontLoops.back(), Vertex());
  for (const Vertex vertex : state.frontLoops) {
    if (vertex.exists()) {
      EXPECT_EQ(state.mesh.kinds[vertex], VertexKind::front1);
    }
  }
}

// Off a straight side with equal edges the first front stands over the middle of every edge, at the height of an
// equilateral triangle. Its points are Δx apart up to rounding, which refused every second one.
TEST(Fronts, GiveAStraightSideEquilateralTriangles) {
  MeshState state = support::after(support::domainFrom(R"({"min_edge_length": 1,
    "outer": [[0, 0], [40, 0], [40, 30], [0, 30]], "density": [{"box": [[0, 0], [40, 30]], "rank": 1}]})"),
                                   Stage::front1);
  int looked = 0;
  for (const BoundaryEdge& edge : state.mesh.edges) {
    const Point a = pointOf(state.mesh, edge.v0), b = pointOf(state.mesh, edge.v1);
    if (a.y != 0.0 || b.y != 0.0 || std::min(a.x, b.x) < 5.0 || std::max(a.x, b.x) > 35.0) continue;
    const Point apex = pointOf(state.mesh, apexOf(state.mesh, findHalfEdge(state.mesh, edge.v0, edge.v1)));
    EXPECT_NEAR(apex.x, 0.5 * (a.x + b.x), 1e-9);
    EXPECT_NEAR(apex.y, 0.5 * std::sqrt(3.0) * distance(a, b), 1e-9);
    ++looked;
  }
  EXPECT_GT(looked, 20);
}

// One after the other along a circle of n edges, each point of the first front would take over √n of them from the one
// before: 60 triangles at a time here.
TEST(Fronts, CavitiesStaySmallAlongALongBoundary) {
  MeshState state = support::after(support::domainFrom(R"({"min_edge_length": 0.0005,
    "outer": [[-4, -4], [4, -4], [4, 4], [-4, 4]],
    "holes": [{"name": "disc", "kind": "circle", "center": [0, 0], "radius": 1}],
    "density": [{"loop": "disc", "rank": 1}]})"),
                                   Stage::carve);
  std::vector<Event> events;
  Journal journal{&events};
  while (state.stage <= Stage::front2) advance(state, Grain::stage, journal);
  double inserted = 0.0, removed = 0.0;
  for (const Event& event : events) {
    if (event.kind != EventKind::vertex_inserted) continue;
    inserted += 1.0;
    removed += event.removedCount;
  }
  EXPECT_GT(inserted, 15000.0);
  EXPECT_LT(removed, 10.0 * inserted);
}

}  // namespace
}  // namespace triscope::fronts_test
