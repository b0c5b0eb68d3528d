#include "core/quality/quality.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/mesh/edit.h"
#include "core/quality/bound_figure.h"
#include "support/ids.h"

namespace triscope::quality_test {
namespace {

using support::operator""_slot, support::operator""_v;

TEST(TriangleQuality, OfTheEquilateralTriangle) {
  const double h = std::sqrt(3.0) / 2.0;
  const TriangleQuality q = qualityOf({0, 0}, {1, 0}, {0.5, h});
  EXPECT_NEAR(q.aspect, 2.0, 1e-15);
  EXPECT_NEAR(q.circumradius, 1.0 / std::sqrt(3.0), 1e-15);
  EXPECT_NEAR(q.inradius, 0.5 / std::sqrt(3.0), 1e-15);
  EXPECT_NEAR(q.edgeRatio, 1.0, 1e-15);
  EXPECT_NEAR(q.area, h / 2.0, 1e-15);
  EXPECT_NEAR(q.minAngle, 60.0, 1e-13);
  EXPECT_NEAR(q.maxAngle, 60.0, 1e-13);
  EXPECT_FALSE(q.obtuse);
}

TEST(TriangleQuality, OfTheThreeFourFiveTriangle) {
  const TriangleQuality q = qualityOf({0, 3}, {0, 0}, {4, 0});
  EXPECT_DOUBLE_EQ(q.circumradius, 2.5);
  EXPECT_DOUBLE_EQ(q.inradius, 1.0);
  EXPECT_DOUBLE_EQ(q.aspect, 2.5);
  EXPECT_DOUBLE_EQ(q.edgeRatio, 5.0 / 3.0);
  EXPECT_DOUBLE_EQ(q.shortest, 3.0);
  EXPECT_DOUBLE_EQ(q.longest, 5.0);
  EXPECT_DOUBLE_EQ(q.area, 6.0);
  EXPECT_DOUBLE_EQ(q.maxAngle, 90.0);
  EXPECT_NEAR(q.minAngle, 36.86989764584402, 1e-13);
  EXPECT_FALSE(q.obtuse);
}

TEST(TriangleQuality, AreaIsSignedAndTheRestIsNot) {
  const TriangleQuality q = qualityOf({0, 3}, {4, 0}, {0, 0});
  EXPECT_DOUBLE_EQ(q.area, -6.0);
  EXPECT_DOUBLE_EQ(q.aspect, 2.5);
  EXPECT_DOUBLE_EQ(q.maxAngle, 90.0);
}

TEST(TriangleQuality, ObtuseByTheLastBit) {
  const Point a{0.1, 0.7}, arm{0.3, 0.2};
  EXPECT_FALSE(qualityOf({0, 0}, {1, 0}, {0, 1}).obtuse);
  EXPECT_TRUE(qualityOf({0, 0}, {1, 0}, {-0x1p-60, 1}).obtuse);
  EXPECT_FALSE(qualityOf({0, 0}, {1, 0}, {0x1p-60, 1}).obtuse);
  EXPECT_TRUE(qualityOf(a, a + arm, a + 0.5 * arm + 1e-3 * perpendicular(arm)).obtuse);
}

TEST(TriangleQuality, DegenerateTrianglesAreInfinitelyBad) {
  const TriangleQuality flat = qualityOf({0, 0}, {1, 0}, {2, 0});
  EXPECT_TRUE(std::isinf(flat.aspect));
  EXPECT_EQ(flat.edgeRatio, 2.0);
  EXPECT_EQ(flat.minAngle, 0.0);
  EXPECT_DOUBLE_EQ(flat.maxAngle, 180.0);
  const TriangleQuality point = qualityOf({1, 1}, {1, 1}, {1, 1});
  EXPECT_TRUE(std::isinf(point.aspect));
  EXPECT_TRUE(std::isinf(point.edgeRatio));
}

/// Two triangles on the edge from (0,0) to (4,0): apex (0,3) above and (1,-1) below.
Mesh twoTriangles() {
  Mesh mesh;
  addVertex(mesh, {0, 0}, VertexKind::kept, 1);
  addVertex(mesh, {4, 0}, VertexKind::kept, 1);
  addVertex(mesh, {0, 3}, VertexKind::kept, 1);
  addVertex(mesh, {1, -1}, VertexKind::steiner, 1);
  addVertex(mesh, {9, 9}, VertexKind::removed, 1);
  const Slot below = addTriangle(mesh, 1_v, 0_v, 3_v);
  const Slot above = addTriangle(mesh, 0_v, 1_v, 2_v);
  link(mesh, halfOf(below, 2), halfOf(above, 2));
  addBoundaryEdge(mesh, support::boundaryEdge(1_v, 2_v));
  return mesh;
}

TEST(MeshQuality, FindsTheWorstOfTwo) {
  const Mesh mesh = twoTriangles();
  const Quality q = measure(mesh);
  EXPECT_EQ(q.triangles, 2u);
  EXPECT_EQ(q.vertices, 4u);
  EXPECT_EQ(q.boundaryVertices, 2u);
  EXPECT_EQ(q.obtuse, 1u);
  EXPECT_DOUBLE_EQ(q.area, 8.0);
  EXPECT_DOUBLE_EQ(q.areaRatioMax, 3.0);
  EXPECT_EQ(q.areaRatioAt, 1_slot);
  EXPECT_EQ(q.areaRatioOther, 0_slot);
  EXPECT_EQ(q.aspectAt, 0_slot);
  EXPECT_EQ(q.edgeRatioAt, 0_slot);
  EXPECT_DOUBLE_EQ(q.edgeRatioMax, 4.0 / std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(q.minEdge, std::sqrt(2.0));
  EXPECT_EQ(q.minEdgeAt, 0_slot);
  EXPECT_EQ(q.maxAngleAt, 0_slot);
  EXPECT_NEAR(q.maxAngle, 45.0 + std::atan2(3.0, 1.0) * 180.0 / 3.141592653589793, 1e-12);
  EXPECT_FALSE(q.withinBounds());
}

TEST(MeshQuality, TheAreaRatioWithoutAPairIsOne) {
  Mesh mesh;
  for (const Point p : {Point{0, 0}, Point{1, 0}, Point{0.5, 0.9}}) addVertex(mesh, p, VertexKind::kept, 1);
  addTriangle(mesh, 0_v, 1_v, 2_v);
  const Quality q = measure(mesh);
  EXPECT_EQ(q.areaRatioMax, 1.0);
  EXPECT_EQ(q.areaRatioAt, Slot());
  EXPECT_TRUE(q.withinBounds());
}

TEST(MeshQuality, TiesGoToTheLowestId) {
  Mesh mesh = twoTriangles();
  mesh.points[3_v] = {4, -3};  // the mirror image: every measure is a tie
  EXPECT_EQ(measure(mesh).aspectAt, 0_slot);
  EXPECT_EQ(measure(mesh).areaRatioAt, 0_slot);
  std::swap(mesh.ids[0_slot], mesh.ids[1_slot]);
  const Quality q = measure(mesh);
  for (const Slot at : {q.aspectAt, q.edgeRatioAt, q.minAngleAt, q.maxAngleAt, q.minEdgeAt, q.areaRatioAt}) {
    EXPECT_EQ(at, 1_slot);
  }
  EXPECT_EQ(q.areaRatioOther, 0_slot);
}

TEST(MeshQuality, LeavesOutDeadAndHelperTriangles) {
  Mesh mesh = twoTriangles();
  mesh.kinds[3_v] = VertexKind::helper;
  EXPECT_EQ(measure(mesh).triangles, 1u);
  EXPECT_EQ(measure(mesh).areaRatioAt, Slot());
  killTriangle(mesh, 1_slot);
  const Quality none = measure(mesh);
  EXPECT_EQ(none.triangles, 0u);
  EXPECT_EQ(none.aspectAt, Slot());
  EXPECT_EQ(none.vertices, 0u);
}

TEST(BesideBound, NeverReadsLikeABoundItIsNotOn) {
  EXPECT_EQ(besideBound(1.74, 2.0, 2), "1.74");
  EXPECT_EQ(besideBound(1.996, 2.0, 2), "1.996");
  EXPECT_EQ(besideBound(1.99996, 2.0, 2), "1.99996");
  EXPECT_EQ(besideBound(2.0, 2.0, 2), "2.00");
  EXPECT_EQ(besideBound(30.008, 30.0, 1), "30.01");
  EXPECT_EQ(besideBound(29.9, 30.0, 1), "29.9");
  EXPECT_EQ(besideBound(1e9, 2.0, 2), "1000000000.00");
}

}  // namespace
}  // namespace triscope::quality_test
