// The walks against a look at every triangle.
#include "core/mesh/locate.h"

#include <gtest/gtest.h>

#include "core/geometry/predicates.h"
#include "core/mesh/centroid.h"
#include "core/mesh/edit.h"
#include "support/meshes.h"
#include "support/runs.h"

namespace triscope::locate_test {
namespace {

using support::PointSet;
using support::Random;
using support::operator""_slot, support::operator""_v;

bool holds(const Mesh& mesh, Slot slot, Point p) {
  const auto& v = triangleAt(mesh, slot).v;
  for (std::size_t i = 0; i < 3; ++i) {
    if (orient2d(pointOf(mesh, v[i]), pointOf(mesh, v[(i + 1) % 3]), p) < 0) return false;
  }
  return true;
}

std::vector<Point> probesOf(const Mesh& mesh, Random& random) {
  std::vector<Point> probes = support::randomPoints(random, 20, mesh.points[0_v], mesh.points[2_v]);
  for (const Slot slot : support::liveSlots(mesh)) {
    if (random.below(4) != 0) continue;
    const auto& v = triangleAt(mesh, slot).v;
    probes.push_back(pointOf(mesh, v[0]));
    probes.push_back(midpoint(pointOf(mesh, v[0]), pointOf(mesh, v[1])));
  }
  return probes;
}

class Walk : public testing::TestWithParam<PointSet> {};

INSTANTIATE_TEST_SUITE_P(Points, Walk, testing::ValuesIn(support::difficultPoints()),
                         [](const auto& set) { return set.param.name; });

TEST_P(Walk, EndsInATriangleThatHoldsThePointFromAnywhere) {
  const Mesh mesh = support::triangulationOf(GetParam().points);
  Random random{9};
  const std::vector<Slot> live = support::liveSlots(mesh);
  for (const Point p : probesOf(mesh, random)) {
    const Location location = walkTo(mesh, live[random.below(live.size())], p);
    EXPECT_EQ(location.blocked, Half());
    EXPECT_TRUE(holds(mesh, location.triangle, p)) << p.x << ", " << p.y;
  }
}

TEST_P(Walk, StraightEndsInATriangleThatHoldsThePoint) {
  const Mesh mesh = support::triangulationOf(GetParam().points);
  Random random{10};
  const std::vector<Slot> live = support::liveSlots(mesh);
  for (const Point p : probesOf(mesh, random)) {
    const Slot from = live[random.below(live.size())];
    if (!holds(mesh, from, centroidOf(mesh, from))) continue;  // the centroid of a sliver may be rounded out of it
    const Location location = walkStraight(mesh, from, centroidOf(mesh, from), p);
    EXPECT_EQ(location.blocked, Half());
    EXPECT_TRUE(holds(mesh, location.triangle, p)) << p.x << ", " << p.y;
  }
}

TEST(WalkOut, IsBlockedByTheSideInBetween) {
  Random random{2};
  const Mesh mesh = support::triangulationOf(support::randomPoints(random, 40, {0, 0}, {1, 1}));
  for (const Point p : {Point{9, 0.5}, Point{-9, 0.5}, Point{0.5, 9}, Point{0.5, -9}}) {
    for (const Location location :
         {walkTo(mesh, 0_slot, p), walkStraight(mesh, mesh.lastTriangle, centroidOf(mesh, mesh.lastTriangle), p)}) {
      ASSERT_TRUE(location.blocked.exists());
      EXPECT_EQ(triangleOf(location.blocked), location.triangle);
      EXPECT_TRUE(constrained(mesh, location.blocked));
      EXPECT_LT(
          orient2d(pointOf(mesh, startOf(mesh, location.blocked)), pointOf(mesh, endOf(mesh, location.blocked)), p), 0);
    }
  }
}

// In a domain with a hole, a crack and corners: the straight walk is blocked exactly when the segment crosses a
// boundary edge, and then by the first one on the way.
TEST(WalkInADomain, StraightStopsAtTheFirstBoundaryEdgeOnTheWay) {
  const MeshState state = support::after(support::domainFrom(support::kCrackedFrame), Stage::step1);
  const Mesh& mesh = state.mesh;
  const std::vector<Slot> live = support::liveSlots(mesh);
  Random random{12};
  int blocked = 0;
  for (int k = 0; k < 2000; ++k) {
    const Slot start = live[random.below(live.size())];
    const Point from = centroidOf(mesh, start);
    const Point p{random.between(-0.5, 8.5), random.between(-0.5, 8.5)};
    EdgeId first;
    double least = 2.0;
    for (const EdgeId e : mesh.edges.keys()) {
      const Point a = pointOf(mesh, mesh.edges[e].v0), b = pointOf(mesh, mesh.edges[e].v1);
      if (orient2d(from, p, a) * orient2d(from, p, b) >= 0 || orient2d(a, b, from) * orient2d(a, b, p) >= 0) continue;
      const double along = cross(a - from, b - a) / cross(p - from, b - a);
      if (along < least) {
        least = along;
        first = e;
      }
    }
    const Location location = walkStraight(mesh, start, from, p);
    if (!first.exists()) {
      EXPECT_EQ(location.blocked, Half());
      EXPECT_TRUE(holds(mesh, location.triangle, p));
      continue;
    }
    ++blocked;
    ASSERT_TRUE(location.blocked.exists());
    EXPECT_EQ(findBoundaryEdge(mesh, startOf(mesh, location.blocked), endOf(mesh, location.blocked)), first);
  }
  EXPECT_GT(blocked, 100);
  EXPECT_LT(blocked, 1900);
}

TEST(WalkInADomain, EndsInTheTriangleOrAtABoundaryEdgeThatHidesThePoint) {
  const MeshState state = support::after(support::domainFrom(support::kCrackedFrame), Stage::step1);
  const Mesh& mesh = state.mesh;
  const std::vector<Slot> live = support::liveSlots(mesh);
  Random random{13};
  for (int k = 0; k < 2000; ++k) {
    const Point p{random.between(-0.5, 8.5), random.between(-0.5, 8.5)};
    const Location location = walkTo(mesh, live[random.below(live.size())], p);
    if (!location.blocked.exists()) {
      EXPECT_TRUE(holds(mesh, location.triangle, p));
    } else {
      EXPECT_TRUE(constrained(mesh, location.blocked));
      EXPECT_LT(
          orient2d(pointOf(mesh, startOf(mesh, location.blocked)), pointOf(mesh, endOf(mesh, location.blocked)), p), 0);
    }
  }
}

}  // namespace
}  // namespace triscope::locate_test
