#include "core/mesh/patch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "core/mesh/edit.h"
#include "core/mesh/move.h"
#include "core/mesh/remove.h"
#include "support/meshes.h"
#include "support/runs.h"

namespace triscope::patch_test {
namespace {

using support::operator""_slot;
using support::Random;

// Slots within `depth` steps across unconstrained edges, by steps over the whole mesh.
std::vector<Slot> within(const Mesh& mesh, Slot slot, int depth) {
  std::map<Slot, int> steps{{slot, 0}};
  for (int ring = 0; ring < depth; ++ring) {
    for (const Slot s : support::liveSlots(mesh)) {
      if (steps.count(s) == 0 || steps[s] != ring) continue;
      for (int i = 0; i < 3; ++i) {
        const Half across = oppositeOf(mesh, halfOf(s, i));
        if (across.exists() && !constrained(mesh, halfOf(s, i))) steps.emplace(triangleOf(across), ring + 1);
      }
    }
  }
  std::vector<Slot> found;
  for (const auto& [s, d] : steps) found.push_back(s);
  return found;
}

class PatchOf : public testing::TestWithParam<const char*> {
 protected:
  MeshState state = support::after(support::domainFrom(GetParam()), Stage::step1);
};

INSTANTIATE_TEST_SUITE_P(Domains, PatchOf, testing::Values(support::kRound, support::kNotched));

TEST_P(PatchOf, IsACopyOfTheTrianglesAround) {
  const Mesh& mesh = state.mesh;
  const std::vector<Slot> live = support::liveSlots(mesh);
  Random random{61};
  Patch patch;
  for (int k = 0; k < 30; ++k) {
    const Slot slot = live[random.below(live.size())];
    const int depth = static_cast<int>(random.below(8));
    extractPatch(mesh, slot, depth, patch);
    EXPECT_EQ(patch.slots.front(), slot);
    std::vector<Slot> slots = patch.slots;
    std::ranges::sort(slots);
    EXPECT_EQ(slots, within(mesh, slot, depth));
    ASSERT_EQ(patch.mesh.triangles.size(), patch.slots.size());
    ASSERT_EQ(patch.mesh.points.size(), patch.vertices.size());
    for (const Vertex v : patch.vertices.keys()) {
      EXPECT_EQ(patch.mesh.points[v], pointOf(mesh, patch.vertices[v]));
      EXPECT_EQ(patch.mesh.kinds[v], mesh.kinds[patch.vertices[v]]);
    }
    for (const Slot local : patch.slots.keys()) {
      EXPECT_EQ(idOf(patch.mesh, local), idOf(mesh, patch.slots[local]));
      for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(patch.vertices[triangleAt(patch.mesh, local).v[i]], triangleAt(mesh, patch.slots[local]).v[i]);
        const Half inner = oppositeOf(patch.mesh, halfOf(local, i));
        const Half outer = oppositeOf(mesh, halfOf(patch.slots[local], i));
        const bool rim = !outer.exists() || std::ranges::count(patch.slots, triangleOf(outer)) == 0;
        EXPECT_EQ(!inner.exists(), rim);
        EXPECT_EQ(constrained(patch.mesh, halfOf(local, i)), rim || constrained(mesh, halfOf(patch.slots[local], i)));
        if (!rim) {
          EXPECT_EQ(patch.slots[triangleOf(inner)], triangleOf(outer));
          EXPECT_EQ(cornerOf(inner), cornerOf(outer));
        }
      }
    }
    ASSERT_EQ(patch.mesh.edges.size(), patch.edges.size());
    for (const EdgeId e : patch.edges.keys()) {
      const BoundaryEdge& small = patch.mesh.edges[e];
      const BoundaryEdge& whole = mesh.edges[patch.edges[e]];
      EXPECT_EQ(patch.vertices[small.v0], whole.v0);
      EXPECT_EQ(patch.vertices[small.v1], whole.v1);
      EXPECT_EQ(small.curve, whole.curve);
      EXPECT_EQ(small.t0, whole.t0);
      EXPECT_EQ(small.t1, whole.t1);
      EXPECT_TRUE(findBoundaryEdge(patch.mesh, small.v0, small.v1).exists());
      EXPECT_TRUE(findBoundaryEdge(patch.mesh, small.v1, small.v0).exists());
    }
  }
}

// What an edit gives in the patch it gives in the mesh, as long as it stays inside the rim and no four points lie on a
// circle.
TEST_P(PatchOf, EditsGiveTheSameTrianglesAsInTheMesh) {
  Random random{62};
  const std::vector<Slot> live = support::liveSlots(state.mesh);
  Patch patch;
  int edits = 0;
  for (int k = 0; k < 40; ++k) {
    const Slot slot = live[random.below(live.size())];
    const Vertex vertex = triangleAt(state.mesh, slot).v[0];
    if (state.mesh.vertexEdge[vertex].exists()) continue;
    extractPatch(state.mesh, slot, 9, patch);
    Mesh mesh = state.mesh;
    const Vertex local = triangleAt(patch.mesh, 0_slot).v[0];
    if (k % 2 == 0) {
      ASSERT_TRUE(removeVertex(mesh, vertex));
      ASSERT_TRUE(removeVertex(patch.mesh, local));
    } else {
      MoveLog log;
      const Point to = pointOf(mesh, vertex) + Point{random.between(-0.05, 0.05), random.between(-0.05, 0.05)};
      ASSERT_EQ(moveVertex(mesh, vertex, to, log), moveVertex(patch.mesh, local, to, log));
    }
    ++edits;
    const auto whole = support::trianglesByPlace(mesh);
    for (const auto& triangle : support::trianglesByPlace(patch.mesh)) {
      EXPECT_EQ(std::ranges::count(whole, triangle), 1);
    }
    EXPECT_EQ(mesh.nextId, patch.mesh.nextId) << "ids run alike";
  }
  EXPECT_GT(edits, 5);
}

}  // namespace
}  // namespace triscope::patch_test
