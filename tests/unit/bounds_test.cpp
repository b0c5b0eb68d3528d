// The promise of the paper's section 3 on every domain that comes with the program.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/quality/quality.h"
#include "support/bounds_cases.h"
#include "support/domains.h"
#include "support/judge.h"
#include "support/runs.h"

namespace triscope::bounds_test {
namespace {

using support::BoundsCase;

std::vector<BoundsCase> samples() {
  std::vector<BoundsCase> cases;
  for (const auto& entry : std::filesystem::directory_iterator(support::samples())) {
    if (entry.path().extension() == ".json") cases.push_back({entry.path()});
  }
  std::ranges::sort(cases, {}, &BoundsCase::file);
  return cases;
}

std::string nameOf(const testing::TestParamInfo<BoundsCase>& info) {
  return info.param.file.stem().string() + (info.param.minEdge > 0.0 ? "_coarse" : "");
}

class SampleDomains : public testing::TestWithParam<BoundsCase> {};

TEST_P(SampleDomains, MeetEveryBound) { support::expectPromise(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Samples, SampleDomains, testing::ValuesIn(samples()), nameOf);
INSTANTIATE_TEST_SUITE_P(TestData, SampleDomains,
                         testing::Values(BoundsCase{support::testData() / "step.json"},
                                         BoundsCase{support::testData() / "corner_over_wall.json"},
                                         BoundsCase{support::testData() / "corner_to_corner.json"},
                                         BoundsCase{support::testData() / "crack_tip_at_wall.json"},
                                         BoundsCase{support::testData() / "plate_with_circle.json"},
                                         BoundsCase{support::testData() / "blunt_body.json"},
                                         BoundsCase{support::testData() / "blunt_body.json", 1.0}),
                         nameOf);

// Paper, section 5, its first example: 3.78 / 2.39 / 1.94 and 74 obtuse with step 6.
TEST(PaperFigures, BluntBodyIsAtLeastAsGood) {
  const MeshState state =
      support::finished(support::domainAt(support::samples() / "blunt_body.json"), support::withoutOptimiser());
  const Quality q = measure(state.mesh);
  EXPECT_LT(q.aspectMax, 3.78);
  EXPECT_LT(q.areaRatioMax, 2.39);
  EXPECT_LT(q.edgeRatioMax, 1.94);
  EXPECT_LE(q.obtuse, 74u);
  const auto count = static_cast<double>(q.triangles);
  EXPECT_LE(std::fabs(state.estimatedTriangles - count), 0.15 * count) << state.estimatedTriangles << " for " << count;
  EXPECT_NEAR(static_cast<double>(q.boundaryVertices), 125.0, 15.0);
}

// The counterpart of the paper's second example: 4.19 / 2.88 / 1.94 over 33,040 triangles, 5.5 % of them obtuse.
TEST(PaperFigures, ThreeElementAirfoilIsAtLeastAsGood) {
  const MeshState state = support::finished(support::domainAt(support::samples() / "three_element_airfoil.json"),
                                            support::withoutOptimiser());
  const Quality q = measure(state.mesh);
  EXPECT_LT(q.aspectMax, 4.19);
  EXPECT_LT(q.areaRatioMax, 2.88);
  EXPECT_LT(q.edgeRatioMax, 1.94);
  const auto count = static_cast<double>(q.triangles);
  EXPECT_NEAR(count, 30000.0, 5000.0);
  EXPECT_LE(std::fabs(state.estimatedTriangles - count), 0.15 * count) << state.estimatedTriangles << " for " << count;
}

TEST(PaperFigures, StepsOneToFiveAreTheSameWithAndWithoutStepSix) {
  const support::DomainPtr domain = support::domainFrom(support::kFrame);
  const MeshState without = support::finished(domain, support::withoutStep6());
  MeshState with = support::after(domain, Stage::step5, support::withoutOptimiser());
  EXPECT_EQ(with.stage, Stage::refine);
  with.stage = Stage::finished;
  EXPECT_EQ(hashOf(with), hashOf(without));
}

}  // namespace
}  // namespace triscope::bounds_test
