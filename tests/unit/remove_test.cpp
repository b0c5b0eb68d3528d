#include "core/mesh/remove.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/mesh/edit.h"
#include "support/judge.h"
#include "support/meshes.h"
#include "support/runs.h"

namespace triscope::remove_test {
namespace {

using support::operator""_v;
using support::PointSet;
using support::Random;

class Remove : public testing::TestWithParam<PointSet> {};

INSTANTIATE_TEST_SUITE_P(Points, Remove, testing::ValuesIn(support::difficultPoints()),
                         [](const auto& set) { return set.param.name; });

TEST_P(Remove, LeavesADelaunayTriangulationUntilNothingIsLeft) {
  Mesh mesh = support::triangulationOf(GetParam().points);
  std::vector<Vertex> inner;
  for (std::size_t v = 4; v < mesh.points.size(); ++v) inner.push_back(Vertex(v));
  Random random{21};
  for (std::size_t k = inner.size(); k > 0; --k) std::swap(inner[k - 1], inner[random.below(k)]);
  for (std::size_t k = 0; k < inner.size(); ++k) {
    const TriangleId nextId = mesh.nextId;
    const std::size_t live = mesh.liveCount();
    ASSERT_TRUE(removeVertex(mesh, inner[k]));
    ASSERT_EQ(mesh.liveCount(), live - 2);
    ASSERT_GT(mesh.nextId, nextId);
    ASSERT_EQ(mesh.kinds[inner[k]], VertexKind::removed);
    ASSERT_EQ(mesh.vertexTriangle[inner[k]], Slot());
    ASSERT_TRUE(mesh.alive(mesh.lastTriangle));
    support::expectValid(mesh);
    if (k % 8 == 0) support::expectDelaunayByBruteForce(mesh);
    if (HasFailure()) return;
  }
  EXPECT_EQ(mesh.liveCount(), 2u);
}

TEST(RemoveVertex, LeavesWhatWasThereBeforeItCame) {
  Random random{22};
  Mesh mesh = support::triangulationOf(support::randomPoints(random, 50, {0, 0}, {1, 1}));
  for (int k = 0; k < 50; ++k) {
    const auto before = support::trianglesOf(mesh);
    const Vertex vertex = support::insert(mesh, {random.unit(), random.unit()});
    ASSERT_TRUE(removeVertex(mesh, vertex));
    EXPECT_EQ(support::trianglesOf(mesh), before);
  }
}

TEST(RemoveVertex, ForgetsOldTestsAround) {
  Random random{23};
  Mesh mesh = support::triangulationOf(support::randomPoints(random, 50, {0, 0}, {1, 1}));
  std::ranges::fill(mesh.tested, std::uint8_t{0xff});
  Star star;
  starOf(mesh, 20_v, star);
  std::vector<Slot> beyond;
  for (const Half rim : star.rim) {
    if (oppositeOf(mesh, rim).exists()) beyond.push_back(triangleOf(oppositeOf(mesh, rim)));
  }
  const TriangleId firstId = mesh.nextId;
  ASSERT_TRUE(removeVertex(mesh, 20_v));
  for (const Slot slot : beyond) EXPECT_EQ(mesh.tested[slot], 0);
  for (const Slot slot : support::liveSlots(mesh)) {
    if (idOf(mesh, slot) >= firstId) {
      EXPECT_EQ(mesh.tested[slot], 0);
    }
  }
}

TEST(RemoveVertex, RefusesTheBoundary) {
  Mesh mesh = support::boxMesh({0, 0}, {1, 1});
  support::insert(mesh, {0.5, 0.5});
  const Mesh before = mesh;
  EXPECT_FALSE(removeVertex(mesh, 0_v));
  EXPECT_EQ(support::difference(mesh, before), "");
}

// Next to holes, cracks and re-entrant corners the polygon to fill has sides that hide its corners from each other.
TEST(RemoveVertex, StaysConstrainedDelaunayNextToBoundaries) {
  for (const char* const json : {support::kFrame, support::kCrackedFrame, support::kRound}) {
    const MeshState state = support::after(support::domainFrom(json), Stage::step5);
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      Mesh mesh = state.mesh;
      std::vector<Vertex> inner;
      for (const Vertex v : mesh.points.keys()) {
        if (!mesh.vertexEdge[v].exists() && mesh.vertexTriangle[v].exists()) inner.push_back(v);
      }
      Random random{seed};
      for (std::size_t k = inner.size(); k > 0; --k) std::swap(inner[k - 1], inner[random.below(k)]);
      for (std::size_t k = 0; k < inner.size(); ++k) {
        ASSERT_TRUE(removeVertex(mesh, inner[k]));
        if (k % 10 == 0 || k + 1 == inner.size()) support::expectValid(mesh);
        if (HasFailure()) return;
      }
    }
  }
}

}  // namespace
}  // namespace triscope::remove_test
