// The sweep over ω and θ, by several threads, against runs that were never stopped.
#include "core/study/parameter_sweep.h"

#include <gtest/gtest.h>

#include "support/domains.h"
#include "support/runs.h"

namespace triscope::parameter_sweep_test {
namespace {

const support::DomainPtr& frame() {
  static const support::DomainPtr domain = support::domainFrom(support::kFrame);
  return domain;
}

TEST(Sweep, RangesAreReadAsTyped) {
  const auto values = rangeFrom("omega", "0.05:0.25:5");
  ASSERT_TRUE(values.ok());
  EXPECT_EQ(*values, (std::vector<double>{0.05, 0.1, 0.15, 0.2, 0.25}));
  EXPECT_EQ(*rangeFrom("theta", "7"), (std::vector<double>{7.0}));
  EXPECT_EQ(*rangeFrom("theta", "10:5:2"), (std::vector<double>{10.0, 5.0}));
  for (const char* wrong : {"", ":", "a:b:3", "0:1", "0:1:0", "0:1:2.5", "0:1:1001", "0:1:2:3", "nan", "0:2:3"})
    EXPECT_FALSE(rangeFrom("omega", wrong).ok()) << wrong;
}

TEST(Sweep, EveryRowIsTheRunWithThoseSettingsWhateverTheThreads) {
  const MeshState start = support::after(frame(), Stage::step5);
  const std::vector<double> omegas{0.05, 0.25};
  const std::vector<double> thetas{5.0, 7.5, 10.0};
  const std::atomic<bool> cancel{false};
  std::vector<SweepRow> told(6);
  std::size_t done = 0;
  const auto tell = [&](std::size_t k, const SweepRow& row) {
    told.at(k) = row;
    ++done;
  };
  const auto rows = sweep(start, omegas, thetas, 3, tell, cancel);
  ASSERT_EQ(rows.size(), 6u);
  EXPECT_EQ(done, 6u);
  EXPECT_EQ(csvOf(told), csvOf(rows));
  for (std::size_t k = 0; k < rows.size(); ++k) {
    Settings settings = support::withoutOptimiser();
    settings.omega = omegas[k / 3];
    settings.theta = thetas[k % 3];
    EXPECT_EQ(rows[k].omega, settings.omega);
    EXPECT_EQ(rows[k].theta, settings.theta);
    const Quality q = measure(support::finished(frame(), settings).mesh);
    EXPECT_EQ(rows[k].quality.aspectMax, q.aspectMax);
    EXPECT_EQ(rows[k].quality.obtuse, q.obtuse);
    EXPECT_EQ(rows[k].quality.triangles, q.triangles);
  }
  EXPECT_EQ(csvOf(rows), csvOf(sweep(start, omegas, thetas, 1, {}, cancel)));
}

TEST(Sweep, CanBeCancelled) {
  const MeshState start = support::after(frame(), Stage::step5);
  const std::atomic<bool> cancel{true};
  EXPECT_TRUE(sweep(start, {0.1}, {7.0}, 2, {}, cancel).empty());
}

TEST(Sweep, CancelledOnTheWayTellsOfNoMorePairs) {
  const MeshState start = support::after(frame(), Stage::step5);
  std::atomic<bool> cancel{false};
  std::size_t done = 0;
  const auto tell = [&](std::size_t, const SweepRow&) {
    if (++done == 2) cancel = true;
  };
  EXPECT_TRUE(sweep(start, valuesOf({0.05, 0.25, 40}), valuesOf({5.0, 10.0, 40}), 2, tell, cancel).empty());
  EXPECT_LT(done, 1600u);
}

TEST(Sweep, GoesOnFromAStateOnlyWhereItIsTheSameRun) {
  const Settings standard;
  Settings swept;
  swept.omega = 0.2;
  swept.theta = 9.0;
  swept.refinePasses = 3;
  Settings earlier;
  earlier.step4AreaRatio = 0.0;
  for (const Stage stage : {Stage::density, Stage::step2, Stage::step5}) {
    const MeshState state = support::after(frame(), stage);
    EXPECT_TRUE(precedesRefinement(state, standard));
    EXPECT_TRUE(precedesRefinement(state, swept));
    EXPECT_FALSE(precedesRefinement(state, earlier));
    EXPECT_FALSE(precedesRefinement(state, support::withoutStep6()));
  }
  MeshState begun = support::after(frame(), Stage::step5);
  Journal nobody;
  advance(begun, Grain::decision, nobody);
  EXPECT_FALSE(precedesRefinement(begun, standard));
  EXPECT_FALSE(precedesRefinement(support::finished(frame()), standard));
}

}  // namespace
}  // namespace triscope::parameter_sweep_test
