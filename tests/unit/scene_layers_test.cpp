// A layer is drawn anew when what it shows has changed, and only then.
#include <gtest/gtest.h>

#include <string>

#include "render/scene.h"
#include "sample_states.h"

namespace triscope::scene_layers_test {
namespace {

/// A square with one hole in it.
std::string around(const std::string& hole) {
  return R"({"name": "edited", "min_edge_length": 1, "outer": [[-8, -8], [8, -8], [8, 8], [-8, 8]], "holes": [)" +
         hole + "]}";
}

/// The boundary as it is drawn once the domain file has been edited and read again.
void expectDrawnAnew(const std::string& before, const std::string& edited) {
  Scene scene = buildScene(sample::start(around(before)), {}, nullptr, nullptr);
  const MeshState again = sample::start(around(edited));
  updateScene(scene, again, {}, nullptr, nullptr);
  const Scene fresh = buildScene(again, {}, nullptr, nullptr);
  const auto& drawn = scene.layer(LayerId::boundary).lines;
  const auto& expected = fresh.layer(LayerId::boundary).lines;
  ASSERT_EQ(drawn.size(), expected.size());
  for (std::size_t i = 0; i < drawn.size(); ++i) EXPECT_EQ(drawn[i].points, expected[i].points) << before;
}

TEST(SceneLayers, ASplineIsDrawnAnewWhenOneOfItsPointsWasMoved) {
  expectDrawnAnew(R"({"kind": "spline", "points": [[-2, -1], [0, -2], [2, -1], [0, 1]]})",
                  R"({"kind": "spline", "points": [[-2, -1], [0, -2], [2, -1], [0, 2]]})");
}

TEST(SceneLayers, ACircleIsDrawnAnewWhenItsFirstPointStayedWhereItWas) {
  expectDrawnAnew(R"({"kind": "circle", "centre": [0, 0], "radius": 2})",
                  R"({"kind": "circle", "centre": [-1, 0], "radius": 3})");
}

}  // namespace
}  // namespace triscope::scene_layers_test
