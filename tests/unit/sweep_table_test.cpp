// The table of a sweep: its best cell, what it holds for, and where values lie in it.
#include "core/study/sweep_table.h"

#include <gtest/gtest.h>

#include <memory>

namespace triscope::sweep_table_test {
namespace {

/// One pair's outcome.
SweepRow row(std::size_t obtuse, double aspect, double minAngle) {
  SweepRow made;
  made.quality.obtuse = obtuse;
  made.quality.aspectMax = aspect;
  made.quality.minAngle = minAngle;
  return made;
}

SweepTable table() {
  SweepTable made = tableOf(nullptr, {}, {0.1, 0.2}, {5.0, 10.0});
  made.cells = {row(7, 3.0, 31.0), row(4, 3.5, 33.0), row(4, 3.25, 32.0), std::nullopt};
  return made;
}

TEST(SweepTable, BeginsWithoutARun) {
  const SweepTable empty = tableOf(nullptr, {}, {0.1, 0.2, 0.3}, {5.0, 10.0});
  EXPECT_EQ(empty.cells.size(), 6u);
  EXPECT_EQ(bestOf(empty, SweepFigure::obtuse), std::nullopt);
  EXPECT_FALSE(spanOf(empty, SweepFigure::aspect));
  EXPECT_TRUE(rowsOf(empty).empty());
}

TEST(SweepTable, BestIsByTheFigureThenByObtuseThenByAspect) {
  EXPECT_EQ(bestOf(table(), SweepFigure::obtuse), 2u);      // as few as cell 1, and a better aspect ratio
  EXPECT_EQ(bestOf(table(), SweepFigure::aspect), 0u);      // the smaller is the better
  EXPECT_EQ(bestOf(table(), SweepFigure::min_angle), 1u);   // the larger is
  EXPECT_EQ(bestOf(table(), SweepFigure::edge_ratio), 2u);  // all the same: by obtuse triangles and aspect ratio
}

TEST(SweepTable, SpanIsOfTheCellsThatWereRun) {
  const std::optional<SweepSpan> obtuse = spanOf(table(), SweepFigure::obtuse);
  ASSERT_TRUE(obtuse);
  EXPECT_EQ(obtuse->low, 4.0);
  EXPECT_EQ(obtuse->high, 7.0);
  EXPECT_EQ(rowsOf(table()).size(), 3u);
}

TEST(SweepTable, HoldsForTheSameDomainAndSettingsButTheSweptOnes) {
  Domain read;
  read.text = "{}";
  const auto domain = std::make_shared<const Domain>(read);
  const auto again = std::make_shared<const Domain>(read);
  read.text = "{ }";
  const auto other = std::make_shared<const Domain>(read);
  const SweepTable made = tableOf(domain, {}, {0.1}, {5.0});
  Settings settings;
  EXPECT_TRUE(holdsFor(made, domain, settings));
  EXPECT_TRUE(holdsFor(made, again, settings)) << "read again and unchanged";
  EXPECT_FALSE(holdsFor(made, other, settings));
  EXPECT_FALSE(holdsFor(made, nullptr, settings));
  settings.omega = 0.3;
  settings.theta = 1.0;
  EXPECT_TRUE(holdsFor(made, domain, settings));
  for (const SettingInfo& info : settingTable()) {
    if (info.key == "omega" || info.key == "theta") continue;
    Settings changed;
    const double value = settingValue(changed, info);
    ASSERT_TRUE(setSetting(changed, info, value == info.lowest ? info.highest : info.lowest)) << info.key;
    EXPECT_FALSE(holdsFor(made, domain, changed)) << info.key;
  }
}

TEST(SweepTable, DomainsMadeInMemoryAreTheSameOnlyAsObjects) {
  const auto a = std::make_shared<const Domain>();
  const auto b = std::make_shared<const Domain>();
  EXPECT_TRUE(holdsFor(tableOf(a, {}, {0.1}, {5.0}), a, {}));
  EXPECT_FALSE(holdsFor(tableOf(a, {}, {0.1}, {5.0}), b, {}));
}

TEST(SweepTable, PlacesLieAmongTheValues) {
  const std::vector<double> values{5.0, 6.0, 8.0};
  EXPECT_EQ(placeAmong(values, 5.0), 0.0);
  EXPECT_EQ(placeAmong(values, 8.0), 2.0);
  EXPECT_EQ(placeAmong(values, 5.5), 0.5);
  EXPECT_EQ(placeAmong(values, 7.5), 1.75);
  EXPECT_EQ(placeAmong(values, 6.0 + 1e-12), 1.0);  // what a control rounds to is that value
  EXPECT_EQ(placeAmong(values, 4.9), std::nullopt);
  EXPECT_EQ(placeAmong(values, 8.1), std::nullopt);
  EXPECT_EQ(placeAmong({7.5}, 7.5), 0.0);
  EXPECT_EQ(placeAmong({7.5}, 7.0), std::nullopt);
  EXPECT_EQ(placeAmong({}, 7.0), std::nullopt);
}

TEST(SweepTable, RangesAreKeptWithinTheSetting) {
  const SettingInfo& omega = *findSetting("omega");
  const SweepRange before{0.05, 0.25, 5};
  EXPECT_EQ(kept(before, before, omega), before);
  EXPECT_EQ(kept({-1.0, 0.25, 5}, before, omega), (SweepRange{0.0, 0.25, 5}));
  EXPECT_EQ(kept({0.05, 7.0, 5}, before, omega), (SweepRange{0.05, 1.0, 5}));
  EXPECT_EQ(kept({0.05, 0.25, 0}, before, omega).count, 1);
  EXPECT_EQ(kept({0.05, 0.25, 1000}, before, omega).count, kMostSweepValues);
  // The end that was not touched gives way.
  EXPECT_EQ(kept({0.5, 0.25, 5}, before, omega), (SweepRange{0.5, 0.5, 5}));
  EXPECT_EQ(kept({0.05, 0.01, 5}, before, omega), (SweepRange{0.01, 0.01, 5}));
}

}  // namespace
}  // namespace triscope::sweep_table_test
