// What is kept of a whole run, against lists of everything.
#include "core/run/run_record.h"

#include <gtest/gtest.h>

#include <vector>

#include "support/runs.h"

namespace triscope::run_record_test {
namespace {

/// A run as a recorder is told of it, and the events after each decision in full.
struct Told {
  RunRecorder recorder;
  std::vector<std::uint64_t> eventsAfter{0};  // by tick
};

void carryOn(Told& told, MeshState& state, std::uint64_t ticks) {
  std::vector<Event> beat;
  Journal journal{&beat};
  std::uint64_t events = told.eventsAfter.back();
  while (state.stage != Stage::finished && state.tick < ticks) {
    beat.clear();
    const std::uint64_t tick = state.tick;
    const std::size_t points = state.mesh.points.size();
    advanceUntil(state, state.stage, 1, journal);
    events += beat.size();
    told.recorder.follow(state, {tick, points, beat, events});
    if (state.tick == tick) continue;
    ASSERT_EQ(state.tick, told.eventsAfter.size());
    told.eventsAfter.push_back(events);
  }
}

void expectDecisions(const Told& told) {
  std::uint64_t tick = 1;
  for (std::uint64_t event = 0; event < told.eventsAfter.back() + 5; ++event) {
    while (tick < told.eventsAfter.size() && told.eventsAfter[tick] <= event) ++tick;
    const auto expected = tick < told.eventsAfter.size() ? std::optional(tick) : std::nullopt;
    ASSERT_EQ(told.recorder.tickOfEvent(event), expected) << "event " << event;
  }
}

TEST(RunRecord, KnowsTheDecisionOfEachEvent) {
  const support::DomainPtr domain = support::domainAt(support::samples() / "step.json");
  Told told;
  expectDecisions(told);
  MeshState state = support::start(domain);
  carryOn(told, state, ~std::uint64_t{0});
  expectDecisions(told);
  EXPECT_GT(told.eventsAfter.back(), told.eventsAfter.size() + 20);  // some decisions made more than one
}

TEST(RunRecord, ForgetsAndGoesOn) {
  const support::DomainPtr domain = support::domainAt(support::samples() / "step.json");
  for (const std::uint64_t cut : {1u, 40u, 300u, 900u}) {
    Told told;
    MeshState state = support::start(domain);
    carryOn(told, state, cut);
    const MeshState kept = state;
    const std::vector<std::uint64_t> before = told.eventsAfter;
    carryOn(told, state, 2000);
    told.recorder.forgetAfter(cut, before.back());
    told.eventsAfter = before;
    expectDecisions(told);
    state = kept;
    carryOn(told, state, ~std::uint64_t{0});
    expectDecisions(told);
  }
}

}  // namespace
}  // namespace triscope::run_record_test
