#include "core/words/settings.h"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <string>

namespace triscope::settings_test {
namespace {

TEST(SettingTable, KeysAreUniqueAndEveryEntryExplainsItself) {
  std::set<std::string_view> keys;
  for (const SettingInfo& info : settingTable()) {
    EXPECT_TRUE(keys.insert(info.key).second) << info.key << " is there twice";
    EXPECT_EQ(findSetting(info.key), &info);
    EXPECT_FALSE(info.label.empty()) << info.key;
    EXPECT_TRUE(info.help.ends_with('.')) << info.key;
    EXPECT_LT(info.lowest, info.highest) << info.key;
    EXPECT_LE(info.paperLow, info.paperHigh) << info.key;
  }
}

TEST(SettingTable, DefaultsAreInRangeAndInThePapersRange) {
  for (const SettingInfo& info : settingTable()) {
    const double standard = settingValue(Settings{}, info);
    EXPECT_GE(standard, info.lowest) << info.key;
    EXPECT_LE(standard, info.highest) << info.key;
    if (info.paperLow == info.paperHigh) continue;
    EXPECT_GE(standard, info.paperLow) << info.key;
    EXPECT_LE(standard, info.paperHigh) << info.key;
  }
}

TEST(SettingTable, EveryMemberOfSettingsIsInIt) {
  // Moving every entry off its default must give a Settings that differs in every member.
  Settings moved;
  for (const SettingInfo& info : settingTable()) {
    const bool isSwitch = info.member.kind == SettingKind::on_off;
    const double standard = settingValue(moved, info);
    const double other = isSwitch ? 1.0 - standard : (standard + 1.0 <= info.highest ? standard + 1.0 : info.lowest);
    ASSERT_TRUE(setSetting(moved, info, other).ok()) << info.key;
    EXPECT_EQ(settingValue(moved, info), other) << info.key;
  }
  const Settings standard;
  EXPECT_NE(moved.minEdge, standard.minEdge);
  EXPECT_NE(moved.curvatureTurn, standard.curvatureTurn);
  EXPECT_NE(moved.cornerTurn, standard.cornerTurn);
  EXPECT_NE(moved.gapFraction, standard.gapFraction);
  EXPECT_NE(moved.maxRank, standard.maxRank);
  EXPECT_NE(moved.maxTriangles, standard.maxTriangles);
  EXPECT_NE(moved.maxRounds, standard.maxRounds);
  EXPECT_NE(moved.omega, standard.omega);
  EXPECT_NE(moved.theta, standard.theta);
  EXPECT_NE(moved.laplacian, standard.laplacian);
  EXPECT_NE(moved.reduceObtuse, standard.reduceObtuse);
  EXPECT_NE(moved.sharedEdge, standard.sharedEdge);
  EXPECT_NE(moved.polish, standard.polish);
  EXPECT_NE(moved.refinePasses, standard.refinePasses);
}

TEST(SetSetting, ReadsNumbersAndSwitches) {
  Settings settings;
  EXPECT_TRUE(setSetting(settings, "omega", "0.05").ok());
  EXPECT_TRUE(setSetting(settings, "min_edge_length", "1e-3").ok());
  EXPECT_TRUE(setSetting(settings, "max_rounds", "12").ok());
  EXPECT_EQ(settings.omega, 0.05);
  EXPECT_EQ(settings.minEdge, 0.001);
  EXPECT_EQ(settings.maxRounds, 12);
  for (const char* const off : {"0", "off", "false", "no"}) {
    settings.laplacian = true;
    EXPECT_TRUE(setSetting(settings, "laplacian", off).ok()) << off;
    EXPECT_FALSE(settings.laplacian) << off;
  }
  for (const char* const on : {"1", "on", "true", "yes"}) {
    settings.laplacian = false;
    EXPECT_TRUE(setSetting(settings, "laplacian", on).ok()) << on;
    EXPECT_TRUE(settings.laplacian) << on;
  }
}

struct Refused {
  const char* key;
  const char* value;
  const char* messageHas;
  const char* hintHas;
};

TEST(SetSetting, RefusesWithAMessageAndChangesNothing) {
  const Refused cases[] = {
      {"omgea", "0.1", "there is no setting 'omgea'", "omega"},
      {"omega", "", "'' is no number", "from 0 to 1 (default 0.15)"},
      {"omega", "abc", "'abc' is no number", "default 0.15"},
      {"omega", "0.1x", "'0.1x' is no number", "default 0.15"},
      {"omega", "0,1", "'0,1' is no number", "default 0.15"},
      {"omega", "nan", "'nan' is no number", "default 0.15"},
      {"omega", "inf", "'inf' is no number", "default 0.15"},
      {"omega", "1.5", "1.5 is out of range", "from 0 to 1"},
      {"omega", "-0.1", "-0.1 is out of range", "from 0 to 1"},
      {"min_edge_length", "-1", "-1 is out of range", "at least 0"},
      {"max_rounds", "2.5", "takes whole numbers, not 2.5", "default 60"},
      {"max_rounds", "99999999999", "out of range", "default 60"},
      {"laplacian", "maybe", "'maybe' is no switch", "on or off (default on)"},
  };
  for (const Refused& refused : cases) {
    Settings settings;
    const Status status = setSetting(settings, refused.key, refused.value);
    ASSERT_FALSE(status.ok()) << refused.key << '=' << refused.value;
    EXPECT_EQ(status.error().kind, ErrorKind::usage);
    EXPECT_NE(status.error().message.find(refused.messageHas), std::string::npos) << status.error().message;
    EXPECT_NE(status.error().hint.find(refused.hintHas), std::string::npos) << status.error().hint;
    EXPECT_EQ(settings, Settings{}) << refused.key << '=' << refused.value;
  }
}

// A row for values with names, kept in a member that has none in the table.
enum class Centre : int { circumcentre, offcentre, spokes };
constexpr std::array kCentres{NamedValue{"circumcentre", 0.0}, NamedValue{"offcentre", 1.0}, NamedValue{"spokes", 2.0}};
constexpr SettingInfo kNamed{
    "placement",
    "",
    "where points are put",
    "",
    {SettingKind::named, [](const Settings& s) { return static_cast<double>(s.maxRounds - 60); },
     [](Settings& s, double value) { s.maxRounds = 60 + static_cast<int>(value); }},
    0.0,
    2.0,
    0.0,
    0.0,
    Stage::step1,
    "Where points are put.",
    kCentres};

TEST(NamedSetting, IsSetByItsNamesAndByNothingElse) {
  Settings settings;
  ASSERT_TRUE(setSetting(settings, kNamed, "spokes").ok());
  EXPECT_EQ(settingValue(settings, kNamed), static_cast<double>(Centre::spokes));
  EXPECT_EQ(settingText(kNamed, 1.0), "offcentre");
  EXPECT_EQ(valueText(kNamed, 1.0), "offcentre");
  EXPECT_EQ(rangeText(kNamed), "circumcentre, offcentre or spokes");
  for (const char* const word : {"2", "on", "Spokes", ""}) {
    const Status status = setSetting(settings, kNamed, word);
    ASSERT_FALSE(status.ok()) << word;
    EXPECT_NE(status.error().message.find("is no value for the setting 'placement'"), std::string::npos);
    EXPECT_EQ(status.error().hint, "give circumcentre, offcentre or spokes (default circumcentre)");
  }
  EXPECT_FALSE(setSetting(settings, kNamed, 0.5).ok());
  EXPECT_FALSE(setSetting(settings, kNamed, 3.0).ok());
  EXPECT_EQ(settingValue(settings, kNamed), 2.0);
}

TEST(SettingTable, NamesEveryValueOfASwitchOrAnEnumAndOfNothingElse) {
  for (const SettingInfo& info : settingTable()) {
    const bool named = info.member.kind == SettingKind::on_off || info.member.kind == SettingKind::named;
    EXPECT_EQ(isNamed(info), named) << info.key;
    if (named) {
      EXPECT_FALSE(valueName(info, info.lowest).empty()) << info.key;
      EXPECT_FALSE(valueName(info, info.highest).empty()) << info.key;
      EXPECT_FALSE(valueName(info, settingValue(Settings{}, info)).empty()) << info.key;
    }
  }
}

}  // namespace
}  // namespace triscope::settings_test
