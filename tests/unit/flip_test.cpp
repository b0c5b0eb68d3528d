#include "core/mesh/flip.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/geometry/predicates.h"
#include "core/mesh/edit.h"
#include "core/mesh/validate.h"
#include "support/judge.h"
#include "support/meshes.h"

namespace triscope::flip_test {
namespace {

using support::Random;
using support::operator""_half, support::operator""_v;

// Both ends see the edge from strictly within the other diagonal.
bool convex(const Mesh& mesh, Half half) {
  const Point a = pointOf(mesh, startOf(mesh, half)), b = pointOf(mesh, endOf(mesh, half));
  const Point c = pointOf(mesh, apexOf(mesh, half)), d = pointOf(mesh, apexOf(mesh, oppositeOf(mesh, half)));
  return orient2d(d, b, c) > 0 && orient2d(c, a, d) > 0;
}

Mesh randomMesh(std::uint64_t seed) {
  Random random{seed};
  return support::triangulationOf(support::randomPoints(random, 80, {0, 0}, {1, 1}));
}

void flipAtRandom(Mesh& mesh, Random& random, int times) {
  while (times > 0) {
    const Half half(random.below(3 * mesh.triangles.size()));
    if (!oppositeOf(mesh, half).exists() || constrained(mesh, half) || !convex(mesh, half)) continue;
    flipEdge(mesh, half);
    --times;
  }
}

// Everything but the Delaunay property.
void expectSoundButForDelaunay(const Mesh& mesh) {
  for (const Violation& violation : validate(mesh)) {
    if (violation.what != Broken::delaunay) ADD_FAILURE() << violation.message;
  }
}

TEST(Flip, GivesTheOtherDiagonalWithFreshIdsInTheSameSlots) {
  Mesh mesh = randomMesh(1);
  std::ranges::fill(mesh.tested, std::uint8_t{0xff});
  Half half(0);
  while (!oppositeOf(mesh, half).exists() || constrained(mesh, half) || !convex(mesh, half)) ++half;
  const Slot left = triangleOf(half), right = triangleOf(oppositeOf(mesh, half));
  const Vertex c = apexOf(mesh, half), d = apexOf(mesh, oppositeOf(mesh, half));
  const TriangleId nextId = mesh.nextId;
  const Half diagonal = flipEdge(mesh, half);
  EXPECT_EQ(std::minmax(startOf(mesh, diagonal), endOf(mesh, diagonal)), std::minmax(c, d));
  EXPECT_EQ(std::minmax(triangleOf(diagonal), triangleOf(oppositeOf(mesh, diagonal))), std::minmax(left, right));
  EXPECT_EQ(mesh.nextId, TriangleId(nextId.n + 2));
  EXPECT_EQ(idOf(mesh, left), nextId);
  EXPECT_EQ(idOf(mesh, right), TriangleId(nextId.n + 1));
  for (const Slot slot : {left, right}) {
    EXPECT_EQ(mesh.tested[slot], 0);
    for (const Half across : triangleAt(mesh, slot).adj) {
      if (across.exists()) {
        EXPECT_EQ(mesh.tested[triangleOf(across)], 0) << "a neighbour keeps old tests";
      }
    }
  }
  expectSoundButForDelaunay(mesh);
}

TEST(Flip, TwiceIsTheSameTriangulation) {
  Mesh mesh = randomMesh(2);
  const auto before = support::trianglesOf(mesh);
  for (const Half half : halvesOf(mesh)) {
    if (!oppositeOf(mesh, half).exists() || constrained(mesh, half) || !convex(mesh, half)) continue;
    flipEdge(mesh, flipEdge(mesh, half));
    ASSERT_EQ(support::trianglesOf(mesh), before);
  }
  support::expectValid(mesh);
}

TEST(Flip, CarriesTheBoundaryEdgesOfItsQuadrilateral) {
  // The diagonal of a box lies between four boundary edges.
  Mesh mesh = support::boxMesh({0, 0}, {2, 1});
  flipEdge(mesh, 1_half);
  EXPECT_EQ(support::trianglesOf(mesh), (std::vector<std::array<Vertex, 3>>{{0_v, 1_v, 3_v}, {1_v, 2_v, 3_v}}));
  support::expectValid(mesh);
}

TEST(FlipWanted, IsDecidedByTheLastBit) {
  for (const double y : {0.0, 0x1p-52, -0x1p-52}) {
    Mesh mesh = support::boxMesh({0, 0}, {1, 1});
    mesh.points[3_v].y += y;
    // The corner leaves the circle of the other three outward when y grows.
    EXPECT_EQ(flipWanted(mesh, 1_half), y < 0.0);
    EXPECT_EQ(flipWanted(mesh, 5_half), y < 0.0);
  }
  const Mesh mesh = support::boxMesh({0, 0}, {1, 1});
  EXPECT_FALSE(flipWanted(mesh, 2_half)) << "a border has no other side";
}

TEST(FlipWanted, NeverForABoundaryEdge) {
  Mesh mesh = support::boxMesh({0, 0}, {1, 1});
  mesh.points[3_v].y = 0.75;
  ASSERT_TRUE(flipWanted(mesh, 1_half));
  constrain(mesh, 1_half);
  constrain(mesh, 5_half);
  EXPECT_FALSE(flipWanted(mesh, 1_half));
}

// The Delaunay triangulation of points in general position is unique: whatever was flipped, flips lead back to it.
TEST(RestoreDelaunay, LeadsBackToTheOneTriangulation) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Mesh mesh = randomMesh(seed);
    const auto delaunay = support::trianglesOf(mesh);
    Random random{seed};
    flipAtRandom(mesh, random, 200);
    expectSoundButForDelaunay(mesh);
    ASSERT_NE(support::trianglesOf(mesh), delaunay);
    std::vector<Half> suspects;
    for (const Half half : halvesOf(mesh)) {
      suspects.push_back(half);
    }
    std::vector<Flip> done;
    restoreDelaunay(mesh, suspects, done, mostFlips(mesh));
    EXPECT_TRUE(suspects.empty());
    EXPECT_FALSE(done.empty());
    EXPECT_EQ(support::trianglesOf(mesh), delaunay);
    support::expectValid(mesh);
  }
}

TEST(RestoreDelaunay, EndsOnCocircularPoints) {
  std::vector<Point> grid;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) grid.push_back({static_cast<double>(i), static_cast<double>(j)});
  }
  Mesh mesh = support::triangulationOf(grid);
  Random random{4};
  flipAtRandom(mesh, random, 100);
  std::vector<Half> suspects;
  for (const Half half : halvesOf(mesh)) {
    suspects.push_back(half);
  }
  std::vector<Flip> done;
  restoreDelaunay(mesh, suspects, done, mostFlips(mesh));
  support::expectValid(mesh);
}

TEST(RestoreDelaunay, StopsWhereItsFlipsAreSpent) {
  Mesh mesh = randomMesh(5);
  Random random{5};
  flipAtRandom(mesh, random, 200);
  std::vector<Half> suspects;
  for (const Half half : halvesOf(mesh)) {
    suspects.push_back(half);
  }
  std::vector<Flip> done(2);
  restoreDelaunay(mesh, suspects, done, 3);
  EXPECT_EQ(done.size(), 5u);
  EXPECT_FALSE(suspects.empty());
  expectSoundButForDelaunay(mesh);
}

TEST(RestoreDelaunay, ListsEachFlip) {
  Mesh mesh = support::boxMesh({0, 0}, {1, 1});
  mesh.points[3_v].y = 0.75;
  std::vector<Half> suspects{1_half};
  std::vector<Flip> done;
  restoreDelaunay(mesh, suspects, done, mostFlips(mesh));
  ASSERT_EQ(done.size(), 1u);
  EXPECT_EQ(std::minmax(done[0].a, done[0].b), std::minmax(0_v, 2_v));
  EXPECT_EQ(std::minmax(done[0].c, done[0].d), std::minmax(1_v, 3_v));
  EXPECT_TRUE(findHalfEdge(mesh, 1_v, 3_v).exists());
  EXPECT_EQ(findHalfEdge(mesh, 0_v, 2_v), Half());
}

}  // namespace
}  // namespace triscope::flip_test
