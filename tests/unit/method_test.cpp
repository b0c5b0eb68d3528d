// Methods as lists of stages, and what the rows of stages say.
#include "core/method/method.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "core/mesh/validate.h"
#include "core/method/pipeline.h"
#include "support/edits.h"
#include "support/meshes.h"
#include "support/runs.h"

namespace triscope::method_test {
namespace {

MeshState finishedBy(const Method& method, const support::DomainPtr& domain) {
  Result<MeshState> begun = begin(domain, {}, {}, method);
  EXPECT_TRUE(begun.ok());
  Journal nobody;
  while (advance(*begun, Grain::stage, nobody))
    EXPECT_TRUE(begun->stage == Stage::finished || std::ranges::count(method.stages, begun->stage) == 1) << method.name;
  return *begun;
}

TEST(Method, ThePapersHasEveryStageInOrder) {
  const std::span<const Stage> list = paperMethod().stages;
  EXPECT_EQ(list.size(), static_cast<std::size_t>(kStageCount) - 1);
  EXPECT_TRUE(std::ranges::is_sorted(list));
}

TEST(Method, OfTheFirstStagesEndsWhereTheOthersGoOn) {
  static constexpr std::array kStages{Stage::constraints,   Stage::quadtree, Stage::density, Stage::boundary,
                                      Stage::triangulation, Stage::recovery, Stage::carve};
  constexpr Method kDelaunay{"triangulation of the boundary", kStages};
  const support::DomainPtr domain = support::domainFrom(support::kNotched);
  const MeshState state = finishedBy(kDelaunay, domain);
  EXPECT_EQ(state.stage, Stage::finished);
  EXPECT_FALSE(state.failed);
  EXPECT_EQ(state.round, 0);
  EXPECT_EQ(support::difference(state.mesh, support::after(domain, Stage::carve).mesh), "");
  EXPECT_TRUE(validate(state.mesh).empty());
}

TEST(Method, MayLeaveOutTheRounds) {
  static constexpr std::array kStages{Stage::constraints,   Stage::quadtree, Stage::density, Stage::boundary,
                                      Stage::triangulation, Stage::recovery, Stage::carve,   Stage::front1,
                                      Stage::front2,        Stage::step1,    Stage::refine};
  constexpr Method kOnce{"without rounds", kStages};
  const MeshState state = finishedBy(kOnce, support::domainFrom(support::kNotched));
  EXPECT_EQ(state.stage, Stage::finished);
  EXPECT_EQ(state.round, 0);
  EXPECT_EQ(state.roundsDone, 0);
  EXPECT_GT(state.passesDone, 0);
  EXPECT_TRUE(validate(state.mesh).empty());
}

TEST(StageRow, SaysWhatATurnIsCalled) {
  EXPECT_EQ(turnText(Stage::step3, 2), "round 2");
  EXPECT_EQ(turnText(Stage::refine, 3), "pass 3");
  EXPECT_EQ(turnText(Stage::refine, 0), "");
  EXPECT_EQ(turnText(Stage::step1, 1), "");
  EXPECT_EQ(turnHeading(Stage::repair, 2), "Round 2 of steps 2 to 5");
  EXPECT_EQ(turnHeading(Stage::refine, 3), "Pass 3 of step 6");
  EXPECT_EQ(turnHeading(Stage::density, 0), "");
}

TEST(FirstAffected, IsTheStageThatReadsTheSettingOrThatDecidesWhetherOneIsRun) {
  const Settings standard;
  EXPECT_EQ(firstAffected(standard, standard), Stage::finished);
  Settings changed;
  changed.omega = 0.1;
  EXPECT_EQ(firstAffected(standard, changed), Stage::refine);
  EXPECT_EQ(firstAffected(support::withoutOptimiser(), support::withoutStep6()), Stage::repair);
  changed.maxRounds = 7;
  EXPECT_EQ(firstAffected(standard, changed), Stage::step2);
  changed = standard;
  changed.placement = Placement::spokes;
  EXPECT_EQ(firstAffected(standard, changed), Stage::carve) << "the last stage that both have";
  changed.placement = Placement::off_centre;
  EXPECT_EQ(firstAffected(standard, changed), Stage::front1);
  changed = standard;
  changed.optimise = false;
  EXPECT_EQ(firstAffected(standard, changed), Stage::refine);
  changed = standard;
  changed.dial = Dial::acute;
  EXPECT_EQ(firstAffected(standard, changed), Stage::optimise);
  changed = standard;
  changed.size = SizeField::continuous;
  EXPECT_EQ(firstAffected(standard, changed), Stage::density);
}

}  // namespace
}  // namespace triscope::method_test
