// Lengths that the picture tells or draws by are those that the mesh is made with.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/number.h"
#include "core/density/wanted.h"
#include "render/scene.h"
#include "sample_states.h"

namespace triscope::scene_lengths_test {
namespace {

/// A step of 0.2, less than the Δx that is given: density rank 1 asks for half of Δx.
const char* const kStep = R"({"min_edge_length": 0.5, "outer": [[0, 0], [8, 0], [8, 8], [7, 8], [7, 7.8], [0, 7.8]]})";

TEST(SceneLengths, TheLegendTellsTheLengthOfARankThatTheTreeAsksFor) {
  const MeshState state = sample::after(kStep, Stage::density);
  ViewOptions view;
  view.quadtree = true;
  view.cells = CellColoring::rank;
  const Scene scene = buildScene(state, view, nullptr, nullptr);
  const auto ramp = std::ranges::find(scene.legend, "density rank", &LegendItem::label);
  ASSERT_NE(ramp, scene.legend.end());
  const std::optional<Wanted> finest = wantedAt(state.tree, {7.0, 7.9});
  ASSERT_TRUE(finest);
  ASSERT_EQ(finest->length, 0.25);
  EXPECT_EQ(ramp->low, "1 (h = " + compact(finest->length) + ")");
}

TEST(SceneLengths, MarksLeaveTheRoomThatTheTreeAsksFor) {
  const MeshState state = sample::after(kStep, Stage::front1);
  const Scene scene = buildScene(state, {}, nullptr, nullptr);
  std::size_t marks = 0;
  for (const LayerId id : {LayerId::points, LayerId::fronts})
    for (const MarkBatch& batch : scene.layer(id).marks)
      for (std::size_t k = 0; k < batch.at.size(); ++k, ++marks)
        EXPECT_EQ(batch.spacing[k], static_cast<float>(wantedAt(state.tree, batch.at[k])->length));
  EXPECT_GT(marks, 0u);
}

}  // namespace
}  // namespace triscope::scene_lengths_test
