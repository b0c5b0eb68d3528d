// Triangles that lie rightly beside their neighbours may still lie over others: the borders tell.
#include "core/mesh/embedding.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/io/mesh_from.h"
#include "core/mesh/edit.h"
#include "support/meshes.h"

namespace triscope::embedding_test {
namespace {

using support::meshOf;

std::string overlapOf(const Mesh& mesh) {
  for (const Violation& v : validate(mesh)) {
    if (v.what == Broken::overlap) return v.message;
    EXPECT_EQ(v.what, Broken::delaunay) << v.message;
  }
  return "";
}

/// A ring of quadrilaterals about the origin, two triangles each: `quads` of them, `turns` times round. Closed, its
/// last quadrilateral is joined to the first.
Mesh ring(int quads, int turns, bool closed) {
  std::vector<Point> points;
  std::vector<std::array<int, 3>> triangles;
  const int rays = closed ? quads : quads + 1;
  for (int k = 0; k < rays; ++k) {
    const double angle = 2.0 * 3.14159265358979 * turns * k / quads;
    // Each turn lies a little further out, so that no two vertices are at one place.
    const double r = 1.0 + 0.1 * k / quads;
    points.push_back({r * std::cos(angle), r * std::sin(angle)});
    points.push_back({2.0 * r * std::cos(angle), 2.0 * r * std::sin(angle)});
  }
  for (int k = 0; k < quads; ++k) {
    const int a = 2 * k, b = 2 * ((k + 1) % rays);
    triangles.push_back({a, a + 1, b + 1});
    triangles.push_back({a, b + 1, b});
  }
  return meshOf(points, triangles);
}

TEST(Embedding, PartsSideBySideAreFine) {
  EXPECT_EQ(overlapOf(meshOf({{0, 0}, {4, 0}, {0, 4}, {5, 0}, {9, 0}, {5, 4}}, {{0, 1, 2}, {3, 4, 5}})), "");
}

TEST(Embedding, PartsThatCrossOverlap) {
  EXPECT_NE(overlapOf(meshOf({{0, 0}, {4, 0}, {0, 4}, {1, 1}, {5, 1}, {1, 5}}, {{0, 1, 2}, {3, 4, 5}})).find("crosses"),
            std::string::npos);
}

TEST(Embedding, APartInsideAnotherOverlaps) {
  EXPECT_NE(overlapOf(meshOf({{0, 0}, {9, 0}, {0, 9}, {1, 1}, {2, 1}, {1, 2}}, {{0, 1, 2}, {3, 4, 5}}))
                .find("inside another part"),
            std::string::npos);
}

TEST(Embedding, PartsThatTouchAreNamed) {
  EXPECT_NE(overlapOf(meshOf({{0, 0}, {4, 0}, {0, 4}, {2, 2}, {5, 2}, {2, 5}}, {{0, 1, 2}, {3, 4, 5}})).find("lies on"),
            std::string::npos);
  EXPECT_NE(overlapOf(meshOf({{0, 0}, {4, 0}, {0, 4}, {1, 0}, {2, -3}, {3, 0}}, {{0, 1, 2}, {3, 4, 5}})), "");
}

TEST(Embedding, APartMayLieInAHole) {
  Mesh mesh = ring(24, 1, true);
  EXPECT_EQ(overlapOf(mesh), "");
  const auto base = static_cast<std::int32_t>(mesh.points.size());
  MeshFile file;
  file.points = mesh.points;
  for (const Triangle& t : mesh.triangles) file.triangles.push_back({t.v[0].n, t.v[1].n, t.v[2].n});
  for (const Point p : {Point{-0.3, -0.3}, Point{0.3, -0.3}, Point{0, 0.3}}) file.points.push_back(p);
  file.triangles.push_back({base, base + 1, base + 2});
  EXPECT_EQ(overlapOf(meshOf(file.points, file.triangles)), "");
}

TEST(Embedding, AStripThatWindsTwiceOverlaps) { EXPECT_NE(overlapOf(ring(40, 2, false)), ""); }

/// Two sheets about one vertex: the fan is closed and every triangle counter-clockwise, but it goes round twice.
TEST(Embedding, AFanThatGoesRoundTwiceOverlaps) {
  std::vector<Point> points{{0, 0}};
  std::vector<std::array<int, 3>> triangles;
  constexpr int kCount = 12;
  for (int k = 0; k < kCount; ++k) {
    const double angle = 4.0 * 3.14159265358979 * k / kCount + 0.01 * k;
    points.push_back({std::cos(angle), std::sin(angle)});
    triangles.push_back({0, 1 + k, 1 + (k + 1) % kCount});
  }
  EXPECT_NE(overlapOf(meshOf(points, triangles)), "");
}

}  // namespace
}  // namespace triscope::embedding_test
