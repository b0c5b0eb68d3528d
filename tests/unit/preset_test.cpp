#include "core/words/preset.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace triscope::preset_test {
namespace {

TEST(Presets, NameSettingsThatThereAreWithValuesTheyMayHave) {
  for (const Preset& preset : presets()) {
    for (const PresetValue& value : preset.values) {
      Settings settings;
      EXPECT_TRUE(setSetting(settings, value.key, value.value).ok()) << preset.key << ": " << value.key;
    }
    EXPECT_FALSE(preset.help.empty());
  }
}

TEST(Presets, TakeEachOthersPlace) {
  for (const Preset& one : presets()) {
    for (const Preset& other : presets()) {
      Settings settings;
      applyPreset(settings, one);
      applyPreset(settings, other);
      EXPECT_EQ(presetOf(settings), &other) << one.key << ", then " << other.key;
      Settings alone;
      applyPreset(alone, other);
      EXPECT_EQ(settings, alone);
    }
  }
}

TEST(Presets, StandardIsWhatIsRunWhenNothingIsSaid) {
  Settings settings;
  ASSERT_TRUE(applyPreset(settings, "standard").ok());
  EXPECT_EQ(settings, Settings{});
}

TEST(Presets, LeaveWhatTheyDoNotName) {
  Settings settings;
  settings.minEdge = 0.25;
  settings.theta = 9.0;
  ASSERT_TRUE(applyPreset(settings, "best").ok());
  EXPECT_EQ(settings.minEdge, 0.25);
  EXPECT_EQ(settings.theta, 9.0);
  settings.omega = 0.2;
  EXPECT_EQ(presetOf(settings)->key, "best");
  settings.placement = Placement::rebay;
  EXPECT_EQ(presetOf(settings), nullptr);
}

TEST(Presets, SayWhichThereAre) {
  Settings settings;
  const Status status = applyPreset(settings, "finest");
  ASSERT_FALSE(status.ok());
  EXPECT_NE(describe(status.error()).find("paper, standard, best"), std::string::npos);
  EXPECT_EQ(settings, Settings{});
}

TEST(Aims, AreTheDialsUnlessTheyAreGiven) {
  Settings settings;
  settings.dial = Dial::easy;
  const Aims easy = aimsOf(settings);
  settings.dial = Dial::acute;
  const Aims acute = aimsOf(settings);
  EXPECT_LT(easy.lowestAngle, acute.lowestAngle);
  EXPECT_GT(easy.highestAngle, acute.highestAngle);
  EXPECT_GT(easy.areaRatio, acute.areaRatio);
  EXPECT_GT(easy.edgeRatio, acute.edgeRatio);
  settings.highestAngle = 85.0;
  EXPECT_EQ(aimsOf(settings).highestAngle, 85.0);
  EXPECT_EQ(aimsOf(settings).lowestAngle, acute.lowestAngle);
}

}  // namespace
}  // namespace triscope::preset_test
