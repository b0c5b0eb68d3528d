// A sound mesh passes; each rule, broken alone, is named.
#include "core/mesh/validate.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/mesh/edit.h"
#include "support/ids.h"

namespace triscope::validate_test {
namespace {

using namespace support;

/// The unit square about a middle vertex: four triangles, four boundary edges.
//     3---2
//     | 4 |
//     0---1
Mesh square() {
  Mesh mesh;
  for (const Point p : {Point{0, 0}, Point{1, 0}, Point{1, 1}, Point{0, 1}}) addVertex(mesh, p, VertexKind::kept, 1);
  addVertex(mesh, {0.5, 0.5}, VertexKind::steiner, 1);
  for (std::int32_t i = 0; i < 4; ++i) addTriangle(mesh, Vertex(i), Vertex((i + 1) % 4), 4_v);
  for (std::int32_t i = 0; i < 4; ++i) {
    link(mesh, halfOf(Slot(i), 0), halfOf(Slot((i + 1) % 4), 1));
    constrain(mesh, halfOf(Slot(i), 2));
    addBoundaryEdge(mesh, boundaryEdge(Vertex(i), Vertex((i + 1) % 4)));
  }
  return mesh;
}

void expectOnly(const Mesh& mesh, Broken what, const std::string& part) {
  const auto found = validate(mesh);
  ASSERT_FALSE(found.empty());
  bool named = false;
  for (const Violation& v : found) {
    EXPECT_EQ(v.what, what) << v.message;
    named = named || v.message.find(part) != std::string::npos;
  }
  EXPECT_TRUE(named) << found.front().message;
}

TEST(Validate, ASoundMeshHasNothingToReport) {
  const auto found = validate(square());
  EXPECT_TRUE(found.empty()) << found.front().message;
  EXPECT_TRUE(validate(Mesh{}).empty());
}

TEST(Validate, AMeshWithFreedSlotsIsSound) {
  Mesh mesh = square();
  const Slot extra = addTriangle(mesh, 0_v, 1_v, 2_v);
  killTriangle(mesh, extra);
  for (std::int32_t i = 0; i < 4; ++i) mesh.vertexTriangle[Vertex(i)] = Slot(i);
  mesh.vertexTriangle[4_v] = 0_slot;
  EXPECT_TRUE(validate(mesh).empty());
  mesh.freeSlots.clear();
  expectOnly(mesh, Broken::link, "1 slots are dead but 0 are listed");
}

TEST(Validate, NamesALinkThatDoesNotPointBack) {
  Mesh mesh = square();
  mesh.triangles[0_slot].adj[0] = halfOf(2_slot, 1);
  expectOnly(mesh, Broken::link, "triangle 2 does not point back");
}

TEST(Validate, NamesALinkAcrossAnotherEdge) {
  Mesh mesh = square();
  link(mesh, halfOf(0_slot, 0), halfOf(2_slot, 1));
  link(mesh, halfOf(2_slot, 0), halfOf(1_slot, 1));
  expectOnly(mesh, Broken::link, "instead");
}

TEST(Validate, NamesALinkToNowhere) {
  Mesh mesh = square();
  mesh.triangles[0_slot].adj[0] = 99_half;
  expectOnly(mesh, Broken::link, "99 is no live triangle");
  mesh.triangles[0_slot].adj[0] = Half(-7);
  expectOnly(mesh, Broken::link, "-7 is no live triangle");
}

TEST(Validate, NamesACornerThatIsNoVertex) {
  Mesh mesh = square();
  mesh.triangles[1_slot].v[0] = 77_v;
  expectOnly(mesh, Broken::link, "corner 77 is no vertex");
  mesh.triangles[1_slot].v[0] = 4_v;
  expectOnly(mesh, Broken::link, "are not three vertices");
}

TEST(Validate, NamesIdsThatAreTaken) {
  Mesh mesh = square();
  mesh.ids[3_slot] = 1_id;
  expectOnly(mesh, Broken::link, "slot 1 has the same id");
  mesh.ids[3_slot] = 50_id;
  expectOnly(mesh, Broken::link, "not below the next one");
}

TEST(Validate, NamesArraysOfDifferentLength) {
  Mesh mesh = square();
  mesh.flags.pop_back();
  expectOnly(mesh, Broken::link, "different lengths");
}

TEST(Validate, NamesClockwiseAndFlatTriangles) {
  Mesh mesh = square();
  mesh.points[4_v] = {0.5, 0.0};
  auto found = validate(mesh);
  EXPECT_EQ(std::ranges::count(found, Broken::orientation, &Violation::what), 1);
  mesh.points[4_v] = {0.5, -0x1p-70};
  found = validate(mesh);
  ASSERT_EQ(std::ranges::count(found, Broken::orientation, &Violation::what), 1);
  const auto clockwise = std::ranges::find(found, Broken::orientation, &Violation::what);
  EXPECT_EQ(clockwise->message, "triangle 0: runs clockwise");
  EXPECT_EQ(clockwise->triangle, 0_slot);
}

/// Two triangles on the edge 0-1, vertex 3 on or near the circle of the other.
Mesh kite(Point bottom) {
  Mesh mesh;
  for (const Point p : {Point{-1, 0}, Point{1, 0}, Point{0, 1}, bottom}) addVertex(mesh, p, VertexKind::kept, 1);
  addTriangle(mesh, 0_v, 1_v, 2_v);
  addTriangle(mesh, 1_v, 0_v, 3_v);
  link(mesh, 2_half, 5_half);
  for (const Half half : {0_half, 1_half, 3_half, 4_half}) {
    constrain(mesh, half);
    addBoundaryEdge(mesh, boundaryEdge(startOf(mesh, half), endOf(mesh, half)));
  }
  return mesh;
}

TEST(Validate, DelaunayIsDecidedByTheLastBit) {
  EXPECT_TRUE(validate(kite({0, -1})).empty());
  EXPECT_TRUE(validate(kite({0, -1 - 0x1p-52})).empty());
  expectOnly(kite({0, -1 + 0x1p-53}), Broken::delaunay, "lies inside the circumcircle");
}

TEST(Validate, AConstrainedEdgeNeedNotBeDelaunay) {
  Mesh mesh = kite({0, -0.5});
  constrain(mesh, 2_half);
  constrain(mesh, 5_half);
  addBoundaryEdge(mesh, boundaryEdge(0_v, 1_v));
  EXPECT_TRUE(validate(mesh).empty());
}

TEST(Validate, NamesAnEdgeConstrainedOnOneSide) {
  Mesh mesh = kite({0, -1.5});
  constrain(mesh, 2_half);
  addBoundaryEdge(mesh, boundaryEdge(0_v, 1_v));
  expectOnly(mesh, Broken::link, "constrained on one side only");
}

TEST(Validate, NamesABorderThatIsNoBoundary) {
  Mesh mesh = square();
  mesh.flags[0_slot] = 0;
  expectOnly(mesh, Broken::boundary, "the mesh ends here");
  expectOnly(mesh, Broken::boundary, "no constrained edge of the mesh");
}

TEST(Validate, TheBoxAroundEverythingNeedsNoBoundary) {
  Mesh mesh = square();
  for (std::size_t v = 0; v < 4; ++v) mesh.kinds[Vertex(v)] = VertexKind::helper;
  mesh.edges.clear();
  std::ranges::fill(mesh.vertexEdge, EdgeId());
  std::ranges::fill(mesh.flags, std::uint8_t{0});
  EXPECT_TRUE(validate(mesh).empty());
}

TEST(Validate, NamesABoundaryEdgeThatTheMeshLacks) {
  Mesh mesh = square();
  addBoundaryEdge(mesh, boundaryEdge(0_v, 2_v));
  expectOnly(mesh, Broken::boundary, "boundary edge 4 (0-2): no constrained edge of the mesh");
}

TEST(Validate, NamesABoundaryEdgeMissingFromAList) {
  Mesh mesh = square();
  mesh.vertexEdge[2_v] = {};
  expectOnly(mesh, Broken::boundary, "missing from the list of vertex 2");
}

TEST(Validate, NamesAListThatRunsInACircle) {
  Mesh mesh = square();
  mesh.edges[0_edge].next0 = 0_edge;
  expectOnly(mesh, Broken::boundary, "runs in a circle");
}

TEST(Validate, NamesABoundaryEdgeThatIsThereTwice) {
  Mesh mesh = square();
  addBoundaryEdge(mesh, boundaryEdge(1_v, 0_v));
  expectOnly(mesh, Broken::boundary, "boundary edge 0-1 is there twice");
}

TEST(Validate, NamesBoundaryEdgesWithoutVertices) {
  Mesh mesh = square();
  mesh.edges.push_back(boundaryEdge(3_v, 12_v));
  expectOnly(mesh, Broken::boundary, "are not two vertices");
}

TEST(Validate, NamesAWrongVertexTriangle) {
  Mesh mesh = square();
  mesh.vertexTriangle[0_v] = 1_slot;
  expectOnly(mesh, Broken::vertex, "vertex 0: its triangle, slot 1, is not one around it");
  mesh.vertexTriangle[0_v] = {};
  expectOnly(mesh, Broken::vertex, "vertex 0");
}

TEST(Validate, NamesAVertexWithoutTriangle) {
  Mesh mesh = square();
  addVertex(mesh, {3, 3}, VertexKind::front1, 1);
  expectOnly(mesh, Broken::vertex, "vertex 5: no triangle uses it");
  mesh.kinds[5_v] = VertexKind::removed;
  EXPECT_TRUE(validate(mesh).empty());
  mesh.kinds[4_v] = VertexKind::removed;
  expectOnly(mesh, Broken::vertex, "vertex 4: removed, but a triangle uses it");
}

TEST(Validate, NamesAPointWherePartsOnlyTouch) {
  Mesh mesh;
  for (const Point p : {Point{0, 0}, Point{1, 0}, Point{1, 1}, Point{-1, 0}, Point{-1, -1}}) {
    addVertex(mesh, p, VertexKind::kept, 1);
  }
  addTriangle(mesh, 0_v, 1_v, 2_v);
  addTriangle(mesh, 0_v, 3_v, 4_v);
  for (const Half half : halvesOf(mesh)) {
    constrain(mesh, half);
    addBoundaryEdge(mesh, boundaryEdge(startOf(mesh, half), endOf(mesh, half)));
  }
  expectOnly(mesh, Broken::vertex, "parts of the mesh meet only in this point");
}

TEST(Validate, NamesTwoVerticesAtOnePlace) {
  Mesh mesh = square();
  const Vertex twin = addVertex(mesh, {1, 0}, VertexKind::kept, 1);
  addVertex(mesh, {2, 0}, VertexKind::kept, 1);
  addVertex(mesh, {2, 1}, VertexKind::kept, 1);
  addTriangle(mesh, twin, 6_v, 7_v);
  for (const Half half : {12_half, 13_half, 14_half}) {
    constrain(mesh, half);
    addBoundaryEdge(mesh, boundaryEdge(startOf(mesh, half), endOf(mesh, half)));
  }
  expectOnly(mesh, Broken::duplicate, "vertex 5: at the same place as vertex 1");
}

TEST(Validate, StopsAtTheLimit) {
  Mesh mesh = square();
  std::ranges::fill(mesh.vertexTriangle, Slot());
  EXPECT_EQ(validate(mesh).size(), 5u);
  EXPECT_EQ(validate(mesh, 2).size(), 2u);
}

}  // namespace
}  // namespace triscope::validate_test
