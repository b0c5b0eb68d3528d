// Two codes for one insertion held against each other, on many: same triangles and rim in the same order, same slots,
// ids and links after it, same refusals.
#include "core/mesh/seen_cavity.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/mesh/cavity.h"
#include "core/mesh/edit.h"
#include "core/mesh/flip.h"
#include "core/mesh/locate.h"
#include "support/judge.h"
#include "support/meshes.h"

namespace triscope {
namespace {

using support::Random;

void expectSame(const Mesh& mesh, const Cavity& old, const seen::Cavity& cavity) {
  EXPECT_TRUE(std::ranges::equal(cavity.triangles(), old.triangles));
  std::vector<std::int32_t> rim;
  for (const auto& edge : cavity.rim()) rim.push_back(seen::halfEdgeOf(mesh, edge));
  EXPECT_EQ(rim, old.rim);
}

void insertBoth(Mesh& mesh, Point p, std::int32_t start, seen::Cavity& cavity) {
  Mesh other = mesh;
  Cavity old;
  findCavity(other, p, start, old);
  seen::findCavity(mesh, p, start, cavity);
  expectSame(mesh, old, cavity);
  EXPECT_EQ(cavity.nearest, nearestSquaredDistance(mesh, old, p));
  ASSERT_EQ(support::difference(mesh, other), "") << "looking changed the mesh";
  if (cavity.nearest <= 0.0) return;
  const std::int32_t vertex = seen::fillCavity(mesh, cavity, VertexKind::steiner, 7);
  EXPECT_EQ(vertex, fillCavity(other, old, p, VertexKind::steiner, 7));
  ASSERT_EQ(support::difference(mesh, other), "");
  // The fan lies as its star does, but for where it begins.
  Star star;
  starOf(mesh, vertex, star);
  ASSERT_EQ(star.rim.size(), cavity.fan().size());
  for (std::size_t k = 0; k < star.rim.size(); ++k)
    EXPECT_EQ(triangleOf(star.rim[(k + 1) % star.rim.size()]), cavity.fan()[k]);
}

// Whether the point went in.
bool splitBoth(Mesh& mesh, Point p, std::int32_t edge, double t, seen::Cavity& cavity) {
  Mesh other = mesh;
  const BoundaryEdge split = mesh.edges[at(edge)];
  std::int32_t side = findHalfEdge(mesh, split.v0, split.v1);
  if (side < 0) side = findHalfEdge(mesh, split.v1, split.v0);
  Cavity old;
  const bool seesAll = findSplitCavity(other, p, side, old);
  const bool same = seen::findSplitCavity(mesh, p, side, cavity) == seesAll;
  EXPECT_TRUE(same);
  expectSame(mesh, old, cavity);
  EXPECT_EQ(support::difference(mesh, other), "") << "looking changed the mesh";
  if (!same || !seesAll) return false;
  EXPECT_EQ(seen::fillSplitCavity(mesh, cavity, edge, t, 3), fillSplitCavity(other, old, p, edge, t, 3));
  EXPECT_EQ(support::difference(mesh, other), "");
  return true;
}

void constrainSome(Mesh& mesh, Random& random, double share) {
  for (const std::int32_t slot : support::liveSlots(mesh)) {
    for (int i = 0; i < 3; ++i) {
      const std::int32_t half = 3 * slot + i;
      if (oppositeOf(mesh, half) < half || constrained(mesh, half) || random.between(0.0, 1.0) > share) continue;
      setConstrained(mesh, half, true);
      setConstrained(mesh, oppositeOf(mesh, half), true);
      addBoundaryEdge(mesh, {.v0 = startOf(mesh, half), .v1 = endOf(mesh, half), .curve = 9});
    }
  }
}

TEST(SeenCavity, IsThatOfTheOldCode) {
  seen::Cavity cavity;
  for (const support::PointSet& set : support::difficultPoints()) {
    SCOPED_TRACE(set.name);
    Box box;
    for (const Point p : set.points) box.include(p);
    const Point margin{1.1 * box.width() + 1e-9, 1.1 * box.height() + 1e-9};
    for (const double share : {0.0, 0.05, 0.3}) {
      Random random{static_cast<std::uint64_t>(1 + 100 * share)};
      Mesh mesh = support::boxMesh(box.lo - margin, box.hi + margin);
      std::size_t inserted = 0;
      const auto go = [&](Point p) {
        const Location location = walkTo(mesh, mesh.lastTriangle, p);
        if (location.blocked >= 0) return;
        const std::size_t before = mesh.points.size();
        insertBoth(mesh, p, location.triangle, cavity);
        inserted += mesh.points.size() - before;
      };
      for (const Point p : set.points) go(p);
      constrainSome(mesh, random, share);
      for (const Point p : support::randomPoints(random, 60, box.lo, box.hi)) go(p);
      if (share == 0.0) {
        support::expectDelaunayByBruteForce(mesh);
      }
      EXPECT_GT(inserted, 1u);
      if (HasFailure()) return;
    }
  }
}

TEST(SeenCavity, OfASplitIsThatOfTheOldCode) {
  seen::Cavity cavity;
  std::size_t split = 0, refused = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random{seed};
    Mesh mesh = support::triangulationOf(support::randomPoints(random, 60, {0, 0}, {1, 1}));
    constrainSome(mesh, random, 0.1);
    const double most = 0.2 * static_cast<double>(seed % 4);  // of the edge, off the chord
    for (std::size_t e = 0; e < mesh.edges.size() && e < 60; ++e) {
      const BoundaryEdge edge = mesh.edges[e];
      const Point a = pointOf(mesh, edge.v0), b = pointOf(mesh, edge.v1);
      const Point p = midpoint(a, b) + random.between(-most, most) * perpendicular(b - a);
      const bool in = splitBoth(mesh, p, static_cast<std::int32_t>(e), 0.5 * (edge.t0 + edge.t1), cavity);
      ++(in ? split : refused);
      if (HasFailure()) FAIL() << "seed " << seed << ", edge " << e;
      if (!in) continue;
      Star star;
      starOf(mesh, static_cast<std::int32_t>(mesh.points.size()) - 1, star);
      std::vector<Flip> flips;
      restoreDelaunay(mesh, star.rim, flips);
    }
  }
  EXPECT_GT(split, 1000u);
  EXPECT_GT(refused, 100u);
}

// A vertex in the middle of a circle of very many: the cavity of a point beside it is larger than any room at first.
TEST(SeenCavity, OfVeryManyTrianglesIsThatOfTheOldCode) {
  Mesh mesh = support::boxMesh({-4, -4}, {4, 4});
  constexpr int kHalf = 1500;
  for (int k = 0; k < 2 * kHalf;
       ++k) {  // whole angles are not needed: points of the unit circle by halving the tangent
    const double s = (k % kHalf + 0.5) / kHalf;
    const Point p{(1 - s * s) / (1 + s * s), 2 * s / (1 + s * s)};
    support::insert(mesh, k < kHalf ? p : Point{-p.x, -p.y});
  }
  seen::Cavity cavity;
  for (const Point p : {Point{0.001, -0.002}, Point{0.25, 0.25}, Point{-0.1, 0.3}}) {
    insertBoth(mesh, p, walkTo(mesh, mesh.lastTriangle, p).triangle, cavity);
    if (HasFailure()) return;
  }
  EXPECT_GT(cavity.capacity, 1024u);
  support::expectValid(mesh);
}

}  // namespace
}  // namespace triscope
