#include "render/pick.h"

#include <gtest/gtest.h>

#include "core/geometry/predicates.h"
#include "core/mesh/centroid.h"
#include "sample_states.h"
#include "support/ids.h"

namespace triscope::pick_test {
namespace {

using support::operator""_id, support::operator""_slot;
using Kind = Selection::Kind;

const MeshState& meshed() {
  static const MeshState state = sample::after(sample::kFrame, Stage::step1);
  return state;
}

TEST(Pick, VertexComesBeforeEdgeBeforeTriangle) {
  const Mesh& mesh = meshed().mesh;
  for (const Slot slot : mesh.triangles.keys()) {
    if (!mesh.alive(slot)) continue;
    const Triangle& t = triangleAt(mesh, slot);
    const Pick inside = pick(meshed(), centroidOf(mesh, slot), 1e-3);
    EXPECT_EQ(inside.selection, (Selection{Kind::triangle, slot.n, -1}));
    EXPECT_EQ(inside.id, idOf(mesh, slot).word());
    const Pick corner = pick(meshed(), pointOf(mesh, t.v[0]) + Point{5e-4, 0.0}, 1e-3);
    EXPECT_EQ(corner.selection, (Selection{Kind::vertex, t.v[0].n, -1}));
    EXPECT_NEAR(corner.distance, 5e-4, 1e-9);
    const Pick edge = pick(meshed(), midpoint(pointOf(mesh, t.v[1]), pointOf(mesh, t.v[2])), 1e-3);
    ASSERT_EQ(edge.selection.kind, Kind::edge);
    const Half half = halfOf(edge.selection.slot(), edge.selection.edge);
    EXPECT_EQ(std::min(startOf(mesh, half), endOf(mesh, half)), std::min(t.v[1], t.v[2]));
    EXPECT_EQ(std::max(startOf(mesh, half), endOf(mesh, half)), std::max(t.v[1], t.v[2]));
  }
}

TEST(Pick, CellsAreFoundWhereThereIsNoTriangleOrWhenAskedFor) {
  const Point inHole{0.3, 0.4};
  const Pick hole = pick(meshed(), inHole, 0.1);
  ASSERT_EQ(hole.selection.kind, Kind::cell);
  EXPECT_EQ(hole.selection.index, leafAt(meshed().tree, inHole));
  const Point inside{5.1, 5.2};
  EXPECT_NE(pick(meshed(), inside, 1e-3).selection.kind, Kind::cell);
  EXPECT_EQ(pickCellFirst(meshed(), inside, 1e-3).selection,
            (Selection{Kind::cell, leafAt(meshed().tree, inside), -1}));
}

TEST(Pick, FindsTheEdgeFromOutsideAndNothingFarAway) {
  const Pick border = pick(meshed(), {8.0 + 1e-4, 0.31}, 1e-3);
  EXPECT_EQ(border.selection.kind, Kind::edge);
  EXPECT_EQ(pick(meshed(), {1e6, 1e6}, 1e-3).selection.kind, Kind::none);
}

TEST(Pick, WorksBeforeThereIsAMesh) {
  const MeshState state = sample::after(sample::kFrame, Stage::quadtree);
  EXPECT_EQ(pick(state, {1.0, 1.0}, 0.1).selection.kind, Kind::cell);
  EXPECT_EQ(pick(MeshState{}, {1.0, 1.0}, 0.1).selection.kind, Kind::none);
}

TEST(Pick, AWalkIntoAHoleStillFindsWhatLiesBehindIt) {
  MeshState state = meshed();
  const Point left{-5.03, 0.11};
  const Point right{5.07, 0.13};
  state.mesh.lastTriangle = triangleContaining(state.mesh, left);
  const Slot slot = triangleContaining(state.mesh, right);
  ASSERT_TRUE(slot.exists());
  const Triangle& t = triangleAt(state.mesh, slot);
  for (int i = 0; i < 3; ++i) {
    EXPECT_GE(orient2d(pointOf(state.mesh, t.v[next3(i)]), pointOf(state.mesh, t.v[prev3(i)]), right), 0);
  }
}

TEST(Pick, SlotOfKnowsTheLivingFromTheDead) {
  const Mesh& mesh = meshed().mesh;
  for (const Slot slot : mesh.triangles.keys()) {
    if (mesh.alive(slot)) {
      EXPECT_EQ(slotOf(mesh, idOf(mesh, slot)), slot);
    }
  }
  EXPECT_EQ(slotOf(mesh, 0_id), Slot()) << "the first triangle was around the whole domain and is gone";
  EXPECT_EQ(slotOf(mesh, TriangleId(kNoId)), Slot());
}

TEST(Pick, IsPresentWhereTheMeshHasItAndNowhereElse) {
  const MeshState& later = meshed();
  const MeshState start = sample::start(sample::kFrame);
  for (const double reach : {0.0, 0.1, 1.0}) {
    const Pick found = pick(later, {5.0, 5.0}, reach);
    EXPECT_EQ(present(later, found), found.selection);
    EXPECT_EQ(present(start, found), Selection{}) << "no mesh and no tree yet";
  }
  const Pick cell = pickCellFirst(later, {5.0, 5.0}, 0.0);
  EXPECT_EQ(present(later, cell), cell.selection);
  EXPECT_EQ(present(start, cell), Selection{});
  // A slot that another triangle has now does not stand for the one meant.
  const Slot slot = triangleContaining(later.mesh, {5.0, 5.0});
  Pick moved{{Kind::triangle, slot == 0_slot ? 1 : 0, -1}, idOf(later.mesh, slot).word(), 0.0};
  EXPECT_EQ(present(later, moved), (Selection{Kind::triangle, slot.n, -1}));
  moved.id = later.mesh.nextId.word();
  EXPECT_EQ(present(later, moved), Selection{});
}

}  // namespace
}  // namespace triscope::pick_test
