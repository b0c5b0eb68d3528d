#include "core/mesh/move.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/geometry/predicates.h"
#include "core/mesh/edit.h"
#include "support/judge.h"
#include "support/meshes.h"
#include "support/runs.h"

namespace triscope::move_test {
namespace {

using support::operator""_v;
using support::Random;

Mesh randomMesh(std::uint64_t seed) {
  Random random{seed};
  Mesh mesh = support::triangulationOf(support::randomPoints(random, 80, {0, 0}, {1, 1}));
  for (std::uint8_t& tested : mesh.tested) tested = static_cast<std::uint8_t>(random.next());
  return mesh;
}

bool insideStar(const Mesh& mesh, Vertex vertex, Point to) {
  Star star;
  starOf(mesh, vertex, star);
  return star.closed && std::ranges::all_of(star.rim, [&](Half rim) {
           return orient2d(pointOf(mesh, startOf(mesh, rim)), pointOf(mesh, endOf(mesh, rim)), to) > 0;
         });
}

TEST(MoveVertex, LeavesTheDelaunayTriangulationOfTheMovedPoints) {
  Mesh mesh = randomMesh(1);
  Random random{31};
  MoveLog log;
  int moved = 0, flipped = 0;
  for (int k = 0; k < 600; ++k) {
    const Vertex vertex(4 + random.below(mesh.points.size() - 4));
    const Point from = pointOf(mesh, vertex);
    const Point to = from + Point{random.between(-0.1, 0.1), random.between(-0.1, 0.1)};
    const bool fits = insideStar(mesh, vertex, to);
    const Mesh before = mesh;
    ASSERT_EQ(moveVertex(mesh, vertex, to, log), fits);
    if (!fits) {
      ASSERT_EQ(support::difference(mesh, before), "") << "a refused move changed the mesh";
      continue;
    }
    ++moved;
    flipped += log.flips > 0 ? 1 : 0;
    ASSERT_EQ(pointOf(mesh, vertex), to);
    ASSERT_EQ(mesh.nextId.n, before.nextId.n + 2 * log.flips);
    support::expectValid(mesh);
    if (HasFailure()) return;
    // What changed lies in the slots that the log names.
    for (const Slot slot : mesh.triangles.keys()) {
      const bool named = std::ranges::count(log.slots, slot) > 0;
      if (!named) {
        ASSERT_EQ(mesh.ids[slot], before.ids[slot]);
        ASSERT_EQ(mesh.triangles[slot].v, before.triangles[slot].v);
      } else {
        ASSERT_EQ(mesh.tested[slot], 0);
        for (const Half across : mesh.triangles[slot].adj) {
          if (across.exists()) {
            ASSERT_EQ(mesh.tested[triangleOf(across)], 0);
          }
        }
      }
    }
  }
  EXPECT_GT(moved, 50);
  EXPECT_GT(flipped, 20);
  std::vector<Point> points(mesh.points.begin() + 4, mesh.points.end());
  Mesh afresh = support::boxMesh(mesh.points[0_v], mesh.points[2_v]);
  for (const Point p : points) support::insert(afresh, p);
  EXPECT_EQ(support::trianglesOf(mesh), support::trianglesOf(afresh));
}

TEST(UndoMove, GivesBackTheSameBytes) {
  Mesh mesh = randomMesh(2);
  Random random{32};
  MoveLog log;
  int flipped = 0;
  for (int k = 0; k < 2000; ++k) {
    const Vertex vertex(4 + random.below(mesh.points.size() - 4));
    const Point to = pointOf(mesh, vertex) + Point{random.between(-0.1, 0.1), random.between(-0.1, 0.1)};
    const Mesh before = mesh;
    if (!moveVertex(mesh, vertex, to, log)) continue;
    flipped += log.flips > 0 ? 1 : 0;
    undoMove(mesh, log);
    ASSERT_EQ(support::difference(mesh, before), "") << "after move " << k << " with " << log.flips << " flips";
    if (k % 3 == 0) moveVertex(mesh, vertex, to, log);
    if (k % 5 == 0) std::ranges::fill(mesh.tested, static_cast<std::uint8_t>(random.next()));
  }
  EXPECT_GT(flipped, 50);
}

TEST(UndoMove, GivesBackTheSameBytesNextToBoundaries) {
  const MeshState state = support::after(support::domainFrom(support::kCrackedFrame), Stage::step3);
  Mesh mesh = state.mesh;
  Random random{33};
  MoveLog log;
  for (int k = 0; k < 2000; ++k) {
    const Vertex vertex(random.below(mesh.points.size()));
    if (!mesh.vertexTriangle[vertex].exists() || mesh.vertexEdge[vertex].exists()) continue;
    const Point to = pointOf(mesh, vertex) + Point{random.between(-0.5, 0.5), random.between(-0.5, 0.5)};
    const Mesh before = mesh;
    if (!moveVertex(mesh, vertex, to, log)) continue;
    undoMove(mesh, log);
    ASSERT_EQ(support::difference(mesh, before), "");
    moveVertex(mesh, vertex, to, log);
  }
  support::expectValid(mesh);
}

// Moves that pass through cocircular positions: ties must not make flips run in a circle.
TEST(MoveVertex, EndsOnAGrid) {
  std::vector<Point> grid;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) grid.push_back({static_cast<double>(i), static_cast<double>(j)});
  }
  Mesh mesh = support::triangulationOf(grid);
  Random random{34};
  MoveLog log;
  for (int k = 0; k < 500; ++k) {
    const Vertex vertex(4 + random.below(grid.size()));
    const Point to{0.25 * static_cast<double>(random.below(21)), 0.25 * static_cast<double>(random.below(21))};
    if (!moveVertex(mesh, vertex, to, log)) continue;
    support::expectValid(mesh);
    if (HasFailure()) return;
  }
}

TEST(MoveVertex, RefusesABoundaryVertex) {
  Mesh mesh = support::boxMesh({0, 0}, {1, 1});
  support::insert(mesh, {0.5, 0.5});
  const Mesh before = mesh;
  MoveLog log;
  EXPECT_FALSE(moveVertex(mesh, 0_v, {0.1, 0.1}, log));
  EXPECT_FALSE(moveVertex(mesh, 4_v, {0.5, 0.0}, log)) << "onto a side: a triangle would have no area";
  EXPECT_FALSE(moveVertex(mesh, 4_v, {0.5, -0.1}, log));
  EXPECT_EQ(support::difference(mesh, before), "");
}

}  // namespace
}  // namespace triscope::move_test
