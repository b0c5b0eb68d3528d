#include "core/mesh/degrees.h"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "sample_states.h"
#include "support/meshes.h"

namespace triscope::degrees_test {
namespace {

using support::operator""_v;

/// A vertex at the origin with n triangles over equal parts of an angle, up to a whole turn: the first vertex.
Mesh fan(int n, double degrees) {
  const bool closed = degrees == 360.0;
  std::vector<Point> points{{0.0, 0.0}};
  for (int k = 0; k < (closed ? n : n + 1); ++k) {
    const double angle = k * degrees / n * std::acos(-1.0) / 180.0;
    points.push_back({std::cos(angle), std::sin(angle)});
  }
  const int rim = static_cast<int>(points.size()) - 1;
  std::vector<std::array<int, 3>> triangles;
  for (int k = 0; k < n; ++k) triangles.push_back({0, 1 + k, 1 + (k + 1) % rim});
  return support::meshOf(std::move(points), std::move(triangles));
}

TEST(Degrees, AnInnerVertexIsHeldToSix) {
  for (int n = 3; n <= 12; ++n) EXPECT_EQ(degreeExcess(fan(n, 360.0))[0_v], n - 6) << n << " triangles";
}

TEST(Degrees, AVertexOfTheBoundaryIsHeldToItsAngle) {
  struct Row {
    double degrees;
    int wanted;
  };
  for (const Row& row : {Row{20.0, 1}, Row{60.0, 1}, Row{89.0, 1}, Row{91.0, 2}, Row{120.0, 2}, Row{180.0, 3},
                         Row{300.0, 5}, Row{340.0, 6}})
    for (int n = std::max(1, row.wanted - 1); n <= row.wanted + 2; ++n) {
      if (row.degrees / n >= 180.0) continue;
      EXPECT_EQ(degreeExcess(fan(n, row.degrees))[0_v], n - row.wanted)
          << n << " triangles over " << row.degrees << "°";
    }
}

TEST(Degrees, OfARightAngleOneTriangleIsAsGoodAsTwoHoweverItIsTurned) {
  for (int turn = 0; turn < 400; ++turn) {
    const double c = std::cos(0.0771 * turn), s = std::sin(0.0771 * turn);
    const auto turned = [&](Mesh mesh) {
      for (Point& p : mesh.points) p = {c * p.x - s * p.y + 0.37 * turn, s * p.x + c * p.y - 0.11 * turn};
      return degreeExcess(mesh)[0_v];
    };
    for (const auto& [n, degrees, excess] : {std::tuple{1, 90.0, 0},
                                             {2, 90.0, 0},
                                             {3, 90.0, 1},
                                             {3, 270.0, -1},
                                             {4, 270.0, 0},
                                             {5, 270.0, 0},
                                             {6, 270.0, 1}})
      EXPECT_EQ(turned(fan(n, degrees)), excess) << n << " triangles over " << degrees << "°, turn " << turn;
  }
}

TEST(Degrees, InAWholeMeshTheyAreTheSizesOfTheStars) {
  const MeshState state = sample::after(sample::kFrame, Stage::refine);
  const Per<Vertex, std::int8_t> excess = degreeExcess(state.mesh);
  Star star;
  int irregular = 0;
  for (const Vertex v : state.mesh.points.keys()) {
    if (!state.mesh.vertexTriangle[v].exists()) {
      EXPECT_EQ(excess[v], 0) << "vertex " << v << " is not in the mesh";
      continue;
    }
    irregular += excess[v] != 0 ? 1 : 0;
    if (state.mesh.vertexEdge[v].exists()) continue;
    starOf(state.mesh, v, star);
    EXPECT_EQ(excess[v], static_cast<int>(star.rim.size()) - 6) << "vertex " << v;
  }
  EXPECT_GT(irregular, 0);
}

}  // namespace
}  // namespace triscope::degrees_test
