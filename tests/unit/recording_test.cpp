// Going about in a recorded run, against runs that were never stopped.
#include "core/debug/recording.h"

#include <gtest/gtest.h>

#include "support/domains.h"
#include "support/runs.h"

namespace triscope {
namespace {

const support::DomainPtr& frame() {
  static const support::DomainPtr domain = support::domainFrom(support::kFrame);
  return domain;
}

struct Whole {
  std::vector<Event> events;
  std::vector<std::uint64_t> hashAt;  // by tick
  std::vector<std::size_t> eventsAt;  // by tick
};

const Whole& whole() {
  static const Whole result = [] {
    Whole w;
    MeshState state = support::start(frame());
    Journal journal{&w.events};
    w.hashAt.push_back(hashOf(state));
    w.eventsAt.push_back(0);
    while (advance(state, Grain::decision, journal)) {
      if (state.tick != w.hashAt.size()) continue;
      w.hashAt.push_back(hashOf(state));
      w.eventsAt.push_back(w.events.size());
    }
    return w;
  }();
  return result;
}

TEST(Recording, GoesToAnyTickFromAnywhere) {
  Recording recording(support::start(frame()), std::size_t{64} << 10);
  const std::uint64_t last = whole().hashAt.size() - 1;
  std::uint64_t tick = 1;
  for (int k = 0; k < 200; ++k) {
    tick = (tick * 48271 + 11) % (last + 1);
    ASSERT_TRUE(recording.toTick(tick));
    ASSERT_EQ(recording.state().tick, tick);
    ASSERT_EQ(hashOf(recording.state()), whole().hashAt[tick]) << tick;
    ASSERT_EQ(recording.events().size(), whole().eventsAt[tick]) << tick;
  }
  EXPECT_FALSE(recording.toTick(last + 1));
  EXPECT_TRUE(recording.over());
  EXPECT_EQ(recording.events().size(), whole().events.size());
}

TEST(Recording, GoesToAnyEventFromAnywhere) {
  Recording recording(support::start(frame()), std::size_t{64} << 10);
  const std::size_t count = whole().events.size();
  std::size_t index = 1;
  for (int k = 0; k < 200; ++k) {
    index = (index * 48271 + 11) % count;
    ASSERT_TRUE(recording.toEvent(index));
    ASSERT_GT(recording.events().size(), index);
    // Not a decision later than need be.
    if (recording.state().tick > 0) {
      ASSERT_LE(whole().eventsAt[recording.state().tick - 1], index);
    }
  }
  ASSERT_TRUE(recording.toEvent(count - 1));
  EXPECT_FALSE(recording.toEvent(count));
}

TEST(Recording, GoesToTheBeginningOfAStage) {
  Recording recording(support::start(frame()));
  for (const Stage stage :
       {Stage::refine, Stage::step2, Stage::carve, Stage::constraints, Stage::step5, Stage::step2}) {
    ASSERT_TRUE(recording.toStage(stage));
    EXPECT_EQ(recording.state().stage, stage);
    EXPECT_FALSE(recording.state().cursor.begun);
    if (stage == Stage::step2) {
      EXPECT_EQ(recording.state().round, 1);
    }
  }
  ASSERT_TRUE(recording.toEnd());
  EXPECT_EQ(hashOf(recording.state()), hashOf(support::finished(frame())));
}

TEST(Recording, HitsForwardsAreTheHitsBackwardsReversed) {
  Result<Condition> condition = Condition::compile("inserted and stage == step1");
  ASSERT_TRUE(condition.ok());
  const std::vector<Breakpoint> breakpoints{{*condition}};
  Recording recording(support::start(frame()), std::size_t{64} << 10);
  std::vector<std::size_t> forwards;
  std::vector<Hit> passed;
  while (const auto hit = recording.toNextHit(breakpoints, passed)) {
    EXPECT_EQ(hit->tick, recording.state().tick);
    forwards.push_back(recording.eventOf(*hit));
    EXPECT_EQ(recording.events()[forwards.back()].vertex, hit->event.vertex);
  }
  ASSERT_GT(forwards.size(), 3u);
  EXPECT_TRUE(recording.over());
  while (const auto hit = recording.toPreviousHit(breakpoints)) {
    ASSERT_FALSE(forwards.empty());
    EXPECT_EQ(recording.eventOf(*hit), forwards.back());
    EXPECT_EQ(hashOf(recording.state()), whole().hashAt[hit->tick]);
    forwards.pop_back();
  }
  EXPECT_TRUE(forwards.empty());
}

TEST(Recording, WhatFollowsTheLastDecisionCanBeMet) {
  Result<Condition> condition = Condition::compile("event == stage_finished and stage == refine");
  ASSERT_TRUE(condition.ok());
  const std::vector<Breakpoint> breakpoints{{*condition}};
  Recording recording(support::start(frame()));
  std::vector<Hit> passed;
  const auto hit = recording.toNextHit(breakpoints, passed);
  ASSERT_TRUE(hit.has_value());
  EXPECT_EQ(recording.eventOf(*hit), whole().events.size() - 1);
}

TEST(Recording, APulseCanStopIt) {
  Recording recording(support::start(support::domainAt(support::samples() / "l_shape.json")));
  recording.onPulse([](const MeshState& state) { return state.tick < 2000; });
  EXPECT_FALSE(recording.toEnd());
  EXPECT_GE(recording.state().tick, 2000u);
  EXPECT_LT(recording.state().tick, 4100u);
}

}  // namespace
}  // namespace triscope
