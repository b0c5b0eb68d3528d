// Bowyer-Watson insertion against brute force in rational arithmetic.
#include "core/mesh/cavity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/geometry/predicates.h"
#include "core/mesh/edit.h"
#include "core/mesh/locate.h"
#include "support/judge.h"
#include "support/meshes.h"

namespace triscope {
namespace {

using support::PointSet;
using support::Random;

class BowyerWatson : public testing::TestWithParam<PointSet> {};

INSTANTIATE_TEST_SUITE_P(Points, BowyerWatson, testing::ValuesIn(support::difficultPoints()),
                         [](const auto& set) { return set.param.name; });

TEST_P(BowyerWatson, NoCircleHoldsAnyVertex) {
  const Mesh mesh = support::triangulationOf(GetParam().points);
  support::expectValid(mesh);
  support::expectDelaunayByBruteForce(mesh);
  // Euler: a triangulation of a quadrilateral with n vertices inside has 2n + 2 triangles.
  EXPECT_EQ(mesh.liveCount(), 2 * (mesh.points.size() - 4) + 2);
}

TEST_P(BowyerWatson, TheCavityIsEveryTriangleWhoseCircleHoldsThePoint) {
  std::vector<Point> points = GetParam().points;
  const Point last = points.back();
  points.pop_back();
  Mesh mesh = support::triangulationOf(points);
  Random random{11};
  Box box;
  for (const Point p : GetParam().points) box.include(p);
  std::vector<Point> probes = support::randomPoints(random, 10, box.lo, box.hi);
  probes.push_back(last);
  for (const Point p : probes) {
    const Location location = walkTo(mesh, mesh.lastTriangle, p);
    const auto& corners = triangleAt(mesh, location.triangle).v;
    if (std::ranges::any_of(corners, [&](std::int32_t v) { return pointOf(mesh, v) == p; })) continue;
    const Mesh before = mesh;
    Cavity cavity;
    findCavity(mesh, p, location.triangle, cavity);
    ASSERT_EQ(support::difference(mesh, before), "") << "looking changed the mesh";
    EXPECT_EQ(cavity.triangles.front(), location.triangle);
    std::vector<std::int32_t> expected;
    for (const std::int32_t slot : support::liveSlots(mesh)) {
      const auto& v = triangleAt(mesh, slot).v;
      if (incircle(pointOf(mesh, v[0]), pointOf(mesh, v[1]), pointOf(mesh, v[2]), p) > 0) expected.push_back(slot);
    }
    std::ranges::sort(cavity.triangles);
    EXPECT_EQ(cavity.triangles, expected);
    ASSERT_EQ(cavity.rim.size(), cavity.triangles.size() + 2);
    double nearest = INFINITY;
    for (std::size_t k = 0; k < cavity.rim.size(); ++k) {
      const std::int32_t half = cavity.rim[k];
      const std::int32_t following = cavity.rim[(k + 1) % cavity.rim.size()];
      EXPECT_EQ(endOf(mesh, half), startOf(mesh, following)) << "the rim does not run around the point";
      EXPECT_GT(orient2d(pointOf(mesh, startOf(mesh, half)), pointOf(mesh, endOf(mesh, half)), p), 0);
      nearest = std::min(nearest, squaredDistance(pointOf(mesh, startOf(mesh, half)), p));
    }
    EXPECT_EQ(nearestSquaredDistance(mesh, cavity, p), nearest);
    for (const Point vertex : mesh.points) EXPECT_GE(squaredDistance(vertex, p), nearest);
  }
}

TEST(Cavity, FillingGivesConsecutiveFreshIdsAndForgetsOldTests) {
  Random random{3};
  Mesh mesh = support::triangulationOf(support::randomPoints(random, 40, {0, 0}, {1, 1}));
  std::ranges::fill(mesh.tested, std::uint8_t{0xff});
  const std::uint32_t firstId = mesh.nextId;
  const Point p{0.51, 0.49};
  Cavity cavity;
  findCavity(mesh, p, walkTo(mesh, 0, p).triangle, cavity);
  std::vector<std::int32_t> beyond;
  for (const std::int32_t half : cavity.rim) {
    if (oppositeOf(mesh, half) >= 0) beyond.push_back(triangleOf(oppositeOf(mesh, half)));
  }
  const std::int32_t vertex = fillCavity(mesh, cavity, p, VertexKind::front2, 5);
  EXPECT_EQ(pointOf(mesh, vertex), p);
  EXPECT_EQ(mesh.kinds[at(vertex)], VertexKind::front2);
  EXPECT_EQ(mesh.density[at(vertex)], 5);
  EXPECT_EQ(mesh.nextId, firstId + cavity.rim.size());
  Star star;
  starOf(mesh, vertex, star);
  EXPECT_TRUE(star.closed);
  ASSERT_EQ(star.rim.size(), cavity.rim.size());
  for (const std::int32_t rim : star.rim) {
    EXPECT_GE(idOf(mesh, triangleOf(rim)), firstId);
    EXPECT_EQ(mesh.tested[at(triangleOf(rim))], 0);
  }
  for (const std::int32_t slot : beyond) EXPECT_EQ(mesh.tested[at(slot)], 0);
  EXPECT_TRUE(mesh.alive(mesh.lastTriangle));
}

TEST(Cavity, DoesNotReachThroughABoundaryEdge) {
  // A vertical wall of boundary edges through the middle of a grid.
  std::vector<Point> points;
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 5; ++j) points.push_back({static_cast<double>(i), static_cast<double>(j)});
  }
  Mesh mesh = support::triangulationOf(points);
  for (std::int32_t j = 0; j < 4; ++j) {
    const std::int32_t a = 4 + 2 * 5 + j;
    const std::int32_t half = findHalfEdge(mesh, a, a + 1);
    ASSERT_GE(half, 0);
    setConstrained(mesh, half, true);
    setConstrained(mesh, oppositeOf(mesh, half), true);
    addBoundaryEdge(mesh, {.v0 = a, .v1 = a + 1, .curve = 4});
  }
  const Point p{1.999, 1.5};
  Cavity cavity;
  findCavity(mesh, p, triangleOf(findHalfEdge(mesh, 15, 16)), cavity);
  for (const std::int32_t slot : cavity.triangles) {
    for (const std::int32_t v : triangleAt(mesh, slot).v) EXPECT_LE(pointOf(mesh, v).x, 2.0);
  }
  fillCavity(mesh, cavity, p, VertexKind::steiner, 1);
  support::expectValid(mesh);
}

TEST(SplitCavity, SplitsInnerAndOuterBoundaryEdges) {
  Random random{5};
  Mesh mesh = support::triangulationOf(support::randomPoints(random, 30, {0, 0}, {1, 1}));
  // Make an edge between two inner vertices a boundary edge of its own.
  for (const std::int32_t slot : support::liveSlots(mesh)) {
    const auto& v = triangleAt(mesh, slot).v;
    if (std::ranges::min(v) < 4) continue;
    const std::int32_t half = 3 * slot;
    setConstrained(mesh, half, true);
    setConstrained(mesh, oppositeOf(mesh, half), true);
    addBoundaryEdge(mesh, {.v0 = startOf(mesh, half), .v1 = endOf(mesh, half), .curve = 4});
    break;
  }
  ASSERT_EQ(mesh.edges.size(), 5u);
  for (int times = 0; times < 4; ++times) {
    const auto edges = static_cast<std::int32_t>(mesh.edges.size());
    for (std::int32_t e = 0; e < edges; ++e) {
      const BoundaryEdge old = mesh.edges[at(e)];
      const Point middle = midpoint(pointOf(mesh, old.v0), pointOf(mesh, old.v1));
      const double t = 0.5 * (old.t0 + old.t1);
      Cavity cavity;
      ASSERT_TRUE(findSplitCavity(mesh, middle, findHalfEdge(mesh, old.v0, old.v1), cavity));
      const std::int32_t vertex = fillSplitCavity(mesh, cavity, middle, e, t, 1);
      EXPECT_EQ(mesh.kinds[at(vertex)], VertexKind::split);
      const BoundaryEdge& first = mesh.edges[at(e)];
      const BoundaryEdge& second = mesh.edges.back();
      EXPECT_EQ(first.v0, old.v0);
      EXPECT_EQ(first.v1, vertex);
      EXPECT_EQ(second.v0, vertex);
      EXPECT_EQ(second.v1, old.v1);
      EXPECT_EQ(first.t1, t);
      EXPECT_EQ(second.t0, t);
      EXPECT_EQ(first.curve, old.curve);
      EXPECT_EQ(second.curve, old.curve);
    }
  }
  support::expectValid(mesh);
}

TEST(SplitCavity, RefusesAPointThatDoesNotSeeTheRim) {
  Mesh mesh = support::boxMesh({0, 0}, {4, 4});
  support::insert(mesh, {2, 0.5});
  const Mesh before = mesh;
  Cavity cavity;
  // Above the vertex over the side it splits.
  EXPECT_FALSE(findSplitCavity(mesh, {2, 0.75}, findHalfEdge(mesh, 0, 1), cavity));
  EXPECT_TRUE(cavity.triangles.empty());
  EXPECT_TRUE(cavity.rim.empty());
  EXPECT_EQ(support::difference(mesh, before), "");
}

}  // namespace
}  // namespace triscope
