// What the picture says of how regular a mesh is: sizes of its edges, degrees of its vertices.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/mesh/degrees.h"
#include "legend_item.h"
#include "render/scene_parts.h"
#include "sample_states.h"

namespace triscope::scene_sizes_test {
namespace {

TEST(SceneSizes, ColoursTrianglesByHowFarTheirEdgesAreFromTheLengthWanted) {
  const MeshState state = sample::after(sample::kFrame, Stage::step5);
  const Mesh& mesh = state.mesh;
  float furthest = 0.0f;
  for (const Slot slot : mesh.triangles.keys()) {
    if (!mesh.alive(slot)) continue;
    double worst = 1.0;
    for (int i = 0; i < 3; ++i) {
      const Point a = pointOf(mesh, triangleAt(mesh, slot).v[i]);
      const Point b = pointOf(mesh, triangleAt(mesh, slot).v[next3(i)]);
      const double times = distance(a, b) / edgeLengthAt(state.tree, midpoint(a, b));
      worst = std::max(worst, times < 1.0 ? 1.0 / times : times);
    }
    EXPECT_FLOAT_EQ(detail::measureSlot(state, slot, TriangleFill::size), static_cast<float>(worst));
    furthest = std::max(furthest, static_cast<float>(worst));
  }
  ASSERT_GT(furthest, 1.42f) << "some are off the scale";
  ViewOptions view;
  view.fill = TriangleFill::size;
  const Scene scene = buildScene(state, view, nullptr, nullptr);
  ASSERT_NE(legendItem(scene, "edge length against h"), nullptr);
  EXPECT_EQ(legendItem(scene, "edge length against h")->high, "1.41");
  EXPECT_NE(legendItem(scene, "further off"), nullptr);
  EXPECT_EQ(legendItem(scene, "beyond the bound"), nullptr) << "the paper has no bound on it";
}

TEST(SceneSizes, MarksVerticesOfFewerAndOfMoreThanSixTriangles) {
  const MeshState state = sample::after(sample::kFrame, Stage::step5);
  ViewOptions view;
  EXPECT_TRUE(buildScene(state, view, nullptr, nullptr).layer(LayerId::degrees).marks.empty()) << "not asked for";
  view.degrees = true;
  const Scene scene = buildScene(state, view, nullptr, nullptr);
  std::size_t fewer = 0, more = 0;
  const Per<Vertex, std::int8_t> excess = degreeExcess(state.mesh);
  for (const Vertex v : excess.keys()) {
    fewer += excess[v] < 0 ? 1u : 0u;
    more += excess[v] > 0 ? 1u : 0u;
  }
  ASSERT_GT(fewer, 0u);
  ASSERT_GT(more, 0u);
  const std::vector<MarkBatch>& marks = scene.layer(LayerId::degrees).marks;
  ASSERT_EQ(marks.size(), 2u);
  EXPECT_EQ(marks[0].at.size(), fewer);
  EXPECT_EQ(marks[1].at.size(), more);
  EXPECT_NE(marks[0].shape, marks[1].shape) << "told apart without colour";
  EXPECT_EQ(legendItem(scene, "vertex of few triangles")->value, std::to_string(fewer));
  EXPECT_EQ(legendItem(scene, "vertex of many triangles")->value, std::to_string(more));
  const MeshState boxed = sample::after(sample::kFrame, Stage::triangulation);
  EXPECT_TRUE(buildScene(boxed, view, nullptr, nullptr).layer(LayerId::degrees).marks.empty());
}

}  // namespace
}  // namespace triscope::scene_sizes_test
