// What is said of an optimised mesh that does not keep to its aims.
#include "core/explain/aim_text.h"

#include <gtest/gtest.h>

#include "support/optimised.h"
#include "support/runs.h"

namespace triscope::aim_text_test {
namespace {

// A corner of 35 degrees, and a hole.
constexpr const char* kWedge = R"({"outer": [[0, 0], [12, 0], [12, 8.4]], "min_edge_length": 0.3,
  "holes": [[[9, 1], [10, 1], [10, 2], [9, 2]]]})";

TEST(AimText, SaysNothingOfAMeshThatKeepsToThem) {
  const MeshState state = support::finished(support::domainFrom(support::kFrame));
  EXPECT_TRUE(unmetAimTexts(state, measure(state.mesh)).empty());
  EXPECT_EQ(obtuseText(state, measure(state.mesh)), "");
}

TEST(AimText, SaysNothingOfAMeshThatIsNotOptimised) {
  const MeshState state = support::finished(support::domainFrom(kWedge), support::withoutOptimiser());
  EXPECT_TRUE(unmetAimTexts(state, measure(state.mesh)).empty());
  EXPECT_EQ(obtuseText(state, measure(state.mesh)), "");
}

TEST(AimText, NamesTheInputAngleThatStandsInTheWay) {
  const MeshState state = support::finished(support::domainFrom(kWedge));
  const std::vector<std::string> texts = unmetAimTexts(state, measure(state.mesh));
  ASSERT_FALSE(texts.empty());
  EXPECT_EQ(texts[0], "smallest angle 35.0, not 44, at the input angle of 35.0° at (0, 0)");
}

TEST(AimText, NamesTheCornerThatStandsInTheWay) {
  Settings settings;
  settings.lowestAngle = 46.0;  // a right corner has room for 45 degrees at most
  const MeshState state = support::finished(
      support::domainFrom(R"({"name": "box", "outer": [[0, 0], [4, 0], [4, 4], [0, 4]], "min_edge_length": 0.5})"),
      settings);
  const std::vector<std::string> texts = unmetAimTexts(state, measure(state.mesh));
  ASSERT_FALSE(texts.empty());
  EXPECT_TRUE(texts[0].starts_with("smallest angle 4")) << texts[0];
  EXPECT_NE(texts[0].find(", not 46, at ("), std::string::npos) << texts[0];
  EXPECT_NE(texts[0].find(" beside "), std::string::npos) << texts[0];
}

// Chains that meet at nine degrees leave obtuse triangles there.
TEST(AimText, ListsObtuseTrianglesByWhereTheyAre) {
  const MeshState state = support::finished(support::domainFrom(
      R"({"outer": [[-10, -10], [10, -10], [10, 10], [-10, 10]], "min_edge_length": 0.5,
          "segments": [[[0, 0], [3, 0]], [[0, 0], [3, 0.5]], [[0, 0], [3, 1]], [[0, 0], [3, 1.5]]]})"));
  const Quality q = measure(state.mesh);
  ASSERT_GT(q.obtuse, 0u);
  const std::string text = obtuseText(state, q);
  EXPECT_TRUE(text.starts_with(std::to_string(q.obtuse) + " obtuse triangle")) << text;
  EXPECT_NE(text.find(" at the input angle of "), std::string::npos) << text;
  EXPECT_NE(text.find("° at (0, 0)"), std::string::npos) << text;
}

}  // namespace
}  // namespace triscope::aim_text_test
