// Bowyer-Watson insertion against brute force in rational arithmetic.
#include "core/mesh/cavity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/geometry/predicates.h"
#include "core/mesh/edit.h"
#include "core/mesh/flip.h"
#include "core/mesh/locate.h"
#include "core/mesh/validate.h"
#include "support/judge.h"
#include "support/meshes.h"

namespace triscope::cavity_test {
namespace {

using support::PointSet;
using support::Random;
using support::operator""_edge, support::operator""_slot, support::operator""_v;

// The rim runs around the point once, which sees all of it; the nearest vertex is on it.
void expectSeesRim(const Mesh& mesh, const Cavity& cavity) {
  ASSERT_EQ(cavity.rimCount, cavity.triangleCount + 2);
  EXPECT_TRUE(cavity.closed());
  double nearest = INFINITY;
  for (std::size_t k = 0; k < cavity.rimCount; ++k) {
    const Half half = halfEdgeOf(mesh, cavity.rim()[k]);
    const Half following = halfEdgeOf(mesh, cavity.rim()[(k + 1) % cavity.rimCount]);
    EXPECT_TRUE(std::ranges::count(cavity.triangles(), triangleOf(half)) == 1);
    EXPECT_EQ(startOf(mesh, half), cavity.rim()[k].vertex);
    EXPECT_EQ(endOf(mesh, half), startOf(mesh, following)) << "the rim does not run around the point";
    EXPECT_GT(orient2d(pointOf(mesh, startOf(mesh, half)), pointOf(mesh, endOf(mesh, half)), cavity.at), 0);
    nearest = std::min(nearest, squaredDistance(pointOf(mesh, startOf(mesh, half)), cavity.at));
  }
  EXPECT_EQ(cavity.nearest, nearest);
}

// The same by brute force: whatever can be reached through edges that are not constrained, triangle by triangle.
std::vector<Slot> reached(const Mesh& mesh, Point p, Slot start) {
  std::vector<Slot> all{start};
  for (std::size_t k = 0; k < all.size(); ++k) {
    for (int i = 0; i < 3; ++i) {
      const Half half = halfOf(all[k], i), across = oppositeOf(mesh, half);
      if (!across.exists() || constrained(mesh, half) || std::ranges::count(all, triangleOf(across)) > 0) continue;
      const auto& v = triangleAt(mesh, triangleOf(across)).v;
      if (incircle(pointOf(mesh, v[0]), pointOf(mesh, v[1]), pointOf(mesh, v[2]), p) > 0)
        all.push_back(triangleOf(across));
    }
  }
  std::ranges::sort(all);
  return all;
}

void constrainSome(Mesh& mesh, Random& random, double share) {
  for (const Slot slot : support::liveSlots(mesh)) {
    for (int i = 0; i < 3; ++i) {
      const Half half = halfOf(slot, i);
      if (oppositeOf(mesh, half) < half || constrained(mesh, half) || random.between(0.0, 1.0) > share) continue;
      constrain(mesh, half);
      constrain(mesh, oppositeOf(mesh, half));
      addBoundaryEdge(mesh, support::boundaryEdge(startOf(mesh, half), endOf(mesh, half), 9));
    }
  }
}

// The new triangles have the next ids, along the rim, and the slots of those that gave way.
void expectFilled(const Mesh& before, const Mesh& mesh, const Cavity& cavity) {
  const std::span<const Slot> fan = cavity.fan(), gone = cavity.triangles();
  ASSERT_GT(fan.size(), gone.size());
  EXPECT_TRUE(std::equal(gone.begin(), gone.end(), fan.begin()));
  EXPECT_EQ(mesh.nextId, TriangleId(before.nextId.n + fan.size()));
  EXPECT_EQ(mesh.liveCount(), before.liveCount() + fan.size() - gone.size());
  for (std::size_t k = 0; k < fan.size(); ++k) {
    EXPECT_EQ(idOf(mesh, fan[k]), TriangleId(before.nextId.n + k));
    EXPECT_EQ(mesh.tested[fan[k]], 0);
    EXPECT_EQ(triangleAt(mesh, fan[k]).v[0], before.points.next());
    const Half beyond = oppositeOf(mesh, halfOf(fan[k], 0));
    if (beyond.exists()) {
      EXPECT_EQ(mesh.tested[triangleOf(beyond)], 0);
    }
  }
}

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
    if (std::ranges::any_of(corners, [&](Vertex v) { return pointOf(mesh, v) == p; })) continue;
    const Mesh before = mesh;
    Cavity cavity;
    findCavity(mesh, p, location.triangle, cavity);
    ASSERT_EQ(support::difference(mesh, before), "") << "looking changed the mesh";
    EXPECT_EQ(cavity.triangles().back(), location.triangle);
    std::vector<Slot> expected;
    for (const Slot slot : support::liveSlots(mesh)) {
      const auto& v = triangleAt(mesh, slot).v;
      if (incircle(pointOf(mesh, v[0]), pointOf(mesh, v[1]), pointOf(mesh, v[2]), p) > 0) expected.push_back(slot);
    }
    std::vector<Slot> found(cavity.triangles().begin(), cavity.triangles().end());
    std::ranges::sort(found);
    EXPECT_EQ(found, expected);
    expectSeesRim(mesh, cavity);
    for (const Point vertex : mesh.points) EXPECT_GE(squaredDistance(vertex, p), cavity.nearest);
  }
}

TEST(Cavity, FillingGivesConsecutiveFreshIdsAndForgetsOldTests) {
  Random random{3};
  Mesh mesh = support::triangulationOf(support::randomPoints(random, 40, {0, 0}, {1, 1}));
  std::ranges::fill(mesh.tested, std::uint8_t{0xff});
  const Point p{0.51, 0.49};
  Cavity cavity;
  findCavity(mesh, p, walkTo(mesh, 0_slot, p).triangle, cavity);
  const Mesh before = mesh;
  const Vertex vertex = fillCavity(mesh, cavity, VertexKind::front2, 5);
  expectFilled(before, mesh, cavity);
  EXPECT_EQ(pointOf(mesh, vertex), p);
  EXPECT_EQ(mesh.kinds[vertex], VertexKind::front2);
  EXPECT_EQ(mesh.density[vertex], 5);
  Star star;
  starOf(mesh, vertex, star);
  EXPECT_TRUE(star.closed);
  ASSERT_EQ(star.rim.size(), cavity.fan().size());
  for (std::size_t k = 0; k < star.rim.size(); ++k)  // the star begins at the last triangle made
    EXPECT_EQ(triangleOf(star.rim[(k + 1) % star.rim.size()]), cavity.fan()[k]);
  EXPECT_EQ(mesh.lastTriangle, cavity.fan().back());
}

TEST(Cavity, IsWhatCanBeReachedBetweenBoundaryEdges) {
  Cavity cavity;
  int inserted = 0;
  for (const PointSet& set : support::difficultPoints()) {
    SCOPED_TRACE(set.name);
    Box box;
    for (const Point p : set.points) box.include(p);
    for (const double share : {0.05, 0.3}) {
      Random random{static_cast<std::uint64_t>(100 * share)};
      Mesh mesh = support::triangulationOf(set.points);
      constrainSome(mesh, random, share);
      for (const Point p : support::randomPoints(random, 60, box.lo, box.hi)) {
        const Location location = walkTo(mesh, mesh.lastTriangle, p);
        if (location.blocked.exists()) continue;
        const Mesh before = mesh;
        findCavity(mesh, p, location.triangle, cavity);
        ASSERT_EQ(support::difference(mesh, before), "") << "looking changed the mesh";
        std::vector<Slot> found(cavity.triangles().begin(), cavity.triangles().end());
        std::ranges::sort(found);
        ASSERT_EQ(found, reached(mesh, p, location.triangle));
        // On a boundary edge, or where a vertex is already, nothing can be filled.
        const auto seesEdge = [&](const Cavity::RimEdge& edge) {
          const Half half = halfEdgeOf(mesh, edge);
          return orient2d(pointOf(mesh, startOf(mesh, half)), pointOf(mesh, endOf(mesh, half)), p) > 0;
        };
        if (!std::ranges::all_of(cavity.rim(), seesEdge)) continue;
        expectSeesRim(mesh, cavity);
        fillCavity(mesh, cavity, VertexKind::steiner, 7);
        expectFilled(before, mesh, cavity);
        ++inserted;
      }
      support::expectValid(mesh);
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(inserted, 100);
}

// Very many vertices on one circle: the cavity of a point within it is larger than any scratch is at first.
TEST(Cavity, MayHaveVeryManyTriangles) {
  Mesh mesh = support::boxMesh({-4, -4}, {4, 4});
  constexpr int kHalf = 1500;
  for (int k = 0; k < 2 * kHalf; ++k) {
    const double s = (k % kHalf + 0.5) / kHalf;  // the tangent of half the angle
    const Point p{(1 - s * s) / (1 + s * s), 2 * s / (1 + s * s)};
    support::insert(mesh, k < kHalf ? p : Point{-p.x, -p.y});
  }
  Cavity cavity;
  for (const Point p : {Point{0.001, -0.002}, Point{0.25, 0.25}}) {
    const Mesh before = mesh;
    const Slot start = walkTo(mesh, mesh.lastTriangle, p).triangle;
    findCavity(mesh, p, start, cavity);
    std::vector<Slot> found(cavity.triangles().begin(), cavity.triangles().end());
    std::ranges::sort(found);
    EXPECT_EQ(found, reached(mesh, p, start));
    expectSeesRim(mesh, cavity);
    if (before.points.size() == 4 + 2 * kHalf) {
      EXPECT_GT(found.size(), 2000u);
    }
    fillCavity(mesh, cavity, VertexKind::steiner, 1);
    expectFilled(before, mesh, cavity);
  }
  support::expectValid(mesh);
}

TEST(Cavity, DoesNotReachThroughABoundaryEdge) {
  // A vertical wall of boundary edges through the middle of a grid.
  std::vector<Point> points;
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 5; ++j) points.push_back({static_cast<double>(i), static_cast<double>(j)});
  }
  Mesh mesh = support::triangulationOf(points);
  for (int j = 0; j < 4; ++j) {
    const Vertex a(4 + 2 * 5 + j), b(a.n + 1);
    const Half half = findHalfEdge(mesh, a, b);
    ASSERT_TRUE(half.exists());
    constrain(mesh, half);
    constrain(mesh, oppositeOf(mesh, half));
    addBoundaryEdge(mesh, support::boundaryEdge(a, b, 4));
  }
  const Point p{1.999, 1.5};
  Cavity cavity;
  findCavity(mesh, p, triangleOf(findHalfEdge(mesh, 15_v, 16_v)), cavity);
  for (const Slot slot : cavity.triangles()) {
    for (const Vertex v : triangleAt(mesh, slot).v) EXPECT_LE(pointOf(mesh, v).x, 2.0);
  }
  fillCavity(mesh, cavity, VertexKind::steiner, 1);
  support::expectValid(mesh);
}

TEST(SplitCavity, SplitsInnerAndOuterBoundaryEdges) {
  Random random{5};
  Mesh mesh = support::triangulationOf(support::randomPoints(random, 30, {0, 0}, {1, 1}));
  // Make an edge between two inner vertices a boundary edge of its own.
  for (const Slot slot : support::liveSlots(mesh)) {
    const auto& v = triangleAt(mesh, slot).v;
    if (std::ranges::min(v) < 4_v) continue;
    const Half half = halfOf(slot, 0);
    constrain(mesh, half);
    constrain(mesh, oppositeOf(mesh, half));
    addBoundaryEdge(mesh, support::boundaryEdge(startOf(mesh, half), endOf(mesh, half), 4));
    break;
  }
  ASSERT_EQ(mesh.edges.size(), 5u);
  for (int times = 0; times < 4; ++times) {
    for (const EdgeId e : mesh.edges.keys()) {  // without those that come of it
      const BoundaryEdge old = mesh.edges[e];
      const Point middle = midpoint(pointOf(mesh, old.v0), pointOf(mesh, old.v1));
      const double t = 0.5 * (old.t0 + old.t1);
      Cavity cavity;
      ASSERT_TRUE(findSplitCavity(mesh, middle, findHalfEdge(mesh, old.v0, old.v1), cavity));
      const Vertex vertex = fillSplitCavity(mesh, cavity, e, t, 1);
      EXPECT_EQ(mesh.kinds[vertex], VertexKind::split);
      const BoundaryEdge& first = mesh.edges[e];
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
  EXPECT_FALSE(findSplitCavity(mesh, {2, 0.75}, findHalfEdge(mesh, 0_v, 1_v), cavity));
  EXPECT_TRUE(cavity.triangles().empty());
  EXPECT_TRUE(cavity.rim().empty());
  EXPECT_EQ(support::difference(mesh, before), "");
}

// Points on the chords, and further and further off them: as on a curve that is bent too much, where the cavity of one
// side may reach round the end of a chain to the other.
TEST(SplitCavity, LeavesASoundMeshHoweverFarOffTheChord) {
  Cavity cavity;
  int split = 0, refused = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random{seed};
    Mesh mesh = support::triangulationOf(support::randomPoints(random, 60, {0, 0}, {1, 1}));
    constrainSome(mesh, random, 0.1);
    const double most = 0.4 * static_cast<double>(seed % 4);  // of the edge
    for (EdgeId e(4); e < std::min(mesh.edges.next(), 60_edge); ++e) {
      const BoundaryEdge edge = mesh.edges[e];
      const Point a = pointOf(mesh, edge.v0), b = pointOf(mesh, edge.v1);
      const Point p = midpoint(a, b) + random.between(-most, most) * perpendicular(b - a);
      const Mesh before = mesh;
      const Half side = findHalfEdge(mesh, edge.v0, edge.v1);
      if (!findSplitCavity(mesh, p, side, cavity)) {
        EXPECT_EQ(support::difference(mesh, before), "");
        ++refused;
        continue;
      }
      ++split;
      std::vector<Slot> found(cavity.triangles().begin(), cavity.triangles().end());
      std::ranges::sort(found);
      ASSERT_EQ(std::ranges::adjacent_find(found), found.end()) << "seed " << seed << ", edge " << e;
      fillSplitCavity(mesh, cavity, e, 0.5 * (edge.t0 + edge.t1), 1);
      expectFilled(before, mesh, cavity);
      Star star;
      starOf(mesh, Vertex(mesh.points.size() - 1), star);
      std::vector<Flip> flips;
      restoreDelaunay(mesh, star.rim, flips, mostFlips(mesh));
      // Far off the chord the mesh is no longer Delaunay all over, and may leave its place; but it is a mesh.
      for (const Violation& violation : validate(mesh))
        EXPECT_TRUE(violation.what == Broken::delaunay || violation.what == Broken::overlap) << violation.message;
      if (HasFailure()) FAIL() << "seed " << seed << ", edge " << e;
    }
  }
  EXPECT_GT(split, 500);
  EXPECT_GT(refused, 50);
}

}  // namespace
}  // namespace triscope::cavity_test
