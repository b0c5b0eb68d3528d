// Time travel: every tick sought gives the state of the forward run, whatever the budget.
#include "core/run/history.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "core/domain/read.h"
#include "core/run/driver.h"
#include "core/run/travel.h"
#include "support/runs.h"

namespace triscope::history_test {
namespace {

MeshState start(const std::string& sample, const Settings& settings = {}) {
  Result<Domain> domain = readDomain(std::string(TRISCOPE_SOURCE_DIR) + "/assets/domains/" + sample + ".json");
  EXPECT_TRUE(domain.ok()) << describe(domain.error());
  Result<MeshState> state = begin(std::make_shared<const Domain>(std::move(*domain)), settings);
  EXPECT_TRUE(state.ok());
  return std::move(*state);
}

struct Forward {
  std::vector<std::uint64_t> hashes;  // after tick · stride decisions
  History history;
  MeshState end;
};

Forward runForward(const MeshState& first, std::size_t budget, std::uint64_t stride) {
  Forward forward{{}, History(budget), first};
  Journal journal;
  forward.history.restart(first);
  forward.hashes.push_back(hashOf(first));
  while (forward.end.stage != Stage::finished) {
    const std::uint64_t before = forward.end.tick;
    advance(forward.end, Grain::decision, journal);
    if (forward.end.tick == before) break;
    forward.history.offer(forward.end, 0);
    if (forward.end.tick % stride == 0) forward.hashes.push_back(hashOf(forward.end));
  }
  return forward;
}

void expectEveryTick(const std::string& sample, std::size_t budget, std::uint64_t stride) {
  const Forward forward = runForward(start(sample), budget, stride);
  Journal journal;
  for (std::size_t k = forward.hashes.size(); k-- > 0;) {
    const MeshState state = forward.history.seek(k * stride, journal);
    ASSERT_EQ(state.tick, k * stride);
    ASSERT_EQ(hashOf(state), forward.hashes[k]) << sample << " at tick " << k * stride;
  }
}

TEST(History, SeeksEveryTickOfTheAnnulusBackwards) { expectEveryTick("annulus", std::size_t{64} << 20, 1); }

TEST(History, SeeksBackwardsWithinATinyBudget) { expectEveryTick("annulus", std::size_t{64} << 10, 1); }

TEST(History, SeeksTheBluntBodyBackwards) { expectEveryTick("blunt_body", std::size_t{64} << 20, 7); }

TEST(History, SeeksTheBluntBodyBackwardsWithinATinyBudget) {
  expectEveryTick("blunt_body", std::size_t{64} << 10, 101);
}

TEST(History, StaysWithinItsBudgetAndCoversTheRun) {
  const std::size_t budget = std::size_t{2} << 20;
  const Forward forward = runForward(start("blunt_body"), budget, 1u << 30);
  EXPECT_LE(forward.history.bytes(), budget);
  EXPECT_GE(forward.history.count(), 3u);
  EXPECT_LE(forward.end.tick - forward.history.before(forward.end.tick).state.tick, 2 * forward.history.spacing());
}

TEST(History, ChangingOmegaKeepsWhatCameBeforeStepSix) {
  const Forward forward = runForward(start("blunt_body"), std::size_t{64} << 20, 1u << 30);
  History history = forward.history;
  Settings settings;
  settings.omega = 0.05;
  const std::uint64_t kept = history.changeSettings(settings);
  EXPECT_GT(kept, 0u);
  Journal journal;
  const MeshState sought = history.seek(~std::uint64_t{0}, journal);
  MeshState fresh = start("blunt_body", settings);
  advance(fresh, Grain::all, journal);
  EXPECT_EQ(hashOf(sought), hashOf(fresh));
}

TEST(History, ChangingTheSmallestEdgeKeepsTheStartOnly) {
  const Forward forward = runForward(start("annulus"), std::size_t{64} << 20, 1u << 30);
  History history = forward.history;
  Settings settings;
  settings.curvatureTurn = 20.0;
  EXPECT_EQ(history.changeSettings(settings), 0u);
  EXPECT_EQ(history.count(), 1u);
}

void go(Driver& driver, const Goal& goal) {
  std::vector<Event> fresh;
  headFor(driver, goal);
  while (!isThere(driver)) carryOn(driver, 1u << 20u, {}, fresh);
}

TEST(History, KeepsOneMoreKeyframeNearWhatWasSoughtLast) {
  constexpr std::uint64_t kStride = 509;
  const std::size_t budget = std::size_t{5} << 19;
  const MeshState first = start("naca0012", support::withoutOptimiser());
  const Forward forward = runForward(first, budget, kStride);
  Driver driver;
  driver.run = runFrom(first, budget);
  go(driver, {.kind = Goal::Kind::end});
  ASSERT_GT(driver.run.history.spacing(), 4000u) << "far apart, or there is nothing to see here";
  for (std::size_t k = 0; k < 40; ++k) {
    const std::size_t place = (k * 29 + 17) % forward.hashes.size();
    const std::uint64_t tick = place * kStride;
    go(driver, towardsTick(driver.run, tick));
    ASSERT_EQ(hashOf(driver.run.state), forward.hashes[place]) << "sought decision " << tick;
    EXPECT_LE(driver.run.history.bytes(), budget);
    const std::uint64_t near = driver.run.history.before(tick).state.tick;
    EXPECT_LE(tick - near, 16'384u) << tick;
    // Back over it, and to the place again.
    for (int back = 0; back < 3; ++back) go(driver, Goal(triscope::back(driver.run, Grain::decision)));
    EXPECT_EQ(driver.run.state.tick, tick >= 3 ? tick - 3 : 0);
    go(driver, towardsTick(driver.run, tick));
    ASSERT_EQ(hashOf(driver.run.state), forward.hashes[place]);
  }
  forgetWhatFollows(driver.run);
  EXPECT_LE(driver.run.history.before(~std::uint64_t{0}).state.tick, driver.run.state.tick);
}

// Among edits that are tried, some hundred decisions take as long as ten thousand others.
TEST(History, KeepsItNearerWhereDecisionsTakeLong) {
  Driver driver;
  driver.run = runFrom(start("cracked_plate"), std::size_t{3} << 19);
  go(driver, {.kind = Goal::Kind::end});
  const std::uint64_t tick = driver.run.state.tick - 700;
  ASSERT_GT(driver.run.state.heavyWork, 100'000u);
  ASSERT_GT(driver.run.history.spacing(), 16'384u) << "far apart, or there is nothing to see here";
  go(driver, towardsTick(driver.run, tick));
  const MeshState& near = driver.run.history.before(tick).state;
  EXPECT_LE(workOf(driver.run.state) - workOf(near), 16'384u);
  EXPECT_EQ(driver.run.state.tick, tick);
}

}  // namespace
}  // namespace triscope::history_test
