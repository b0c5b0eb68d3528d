// Going about in a run, against runs that were never stopped.
#include "core/run/driver.h"

#include <gtest/gtest.h>

#include "core/run/event_log.h"
#include "core/run/travel.h"
#include "support/domains.h"
#include "support/runs.h"

namespace triscope::driver_test {
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

/// A run with all its events.
struct Trip {
  explicit Trip(MeshState start, std::size_t budget = kHistoryBytes) { driver.run = runFrom(std::move(start), budget); }
  Driver driver;
  EventLog log;

  /// In slices of some beats. False when the run ends before the goal.
  bool go(const Goal& goal, std::uint64_t beats = 100) {
    headFor(driver, goal);
    while (!isThere(driver)) {
      std::vector<Event> fresh;
      carryOn(driver, beats, {}, fresh);
      log.append(fresh);
    }
    return driver.stopped || arrived(driver.run, goal);
  }
  const MeshState& state() const { return driver.run.state; }
};

constexpr std::size_t kFewBytes = std::size_t{64} << 10;

TEST(Driver, GoesToAnyTickFromAnywhere) {
  Trip trip(support::start(frame()), kFewBytes);
  const std::uint64_t last = whole().hashAt.size() - 1;
  std::uint64_t tick = 1;
  for (int k = 0; k < 200; ++k) {
    tick = (tick * 48271 + 11) % (last + 1);
    ASSERT_TRUE(trip.go(towardsTick(trip.driver.run, tick)));
    ASSERT_EQ(trip.state().tick, tick);
    ASSERT_EQ(hashOf(trip.state()), whole().hashAt[tick]) << tick;
    ASSERT_EQ(trip.driver.run.events, whole().eventsAt[tick]) << tick;
    ASSERT_EQ(trip.log.size(), trip.driver.run.known) << tick;
  }
  EXPECT_FALSE(trip.go(towardsTick(trip.driver.run, last + 1)));
  EXPECT_TRUE(isOver(trip.driver.run));
  ASSERT_EQ(trip.log.size(), whole().events.size());
  for (std::size_t k = 0; k < trip.log.size(); ++k) {
    ASSERT_EQ(trip.log.peek(k).kind, whole().events[k].kind) << k;
    ASSERT_EQ(trip.log.peek(k).at, whole().events[k].at) << k;
  }
}

TEST(Driver, GoesToAnyEventFromAnywhere) {
  Trip trip(support::start(frame()), kFewBytes);
  const std::size_t count = whole().events.size();
  std::size_t index = 1;
  for (int k = 0; k < 200; ++k) {
    index = (index * 48271 + 11) % count;
    ASSERT_TRUE(trip.go(towardsEvent(trip.driver.run, index)));
    ASSERT_GT(trip.driver.run.events, index);
    // Not a decision later than need be.
    if (trip.state().tick > 0) {
      ASSERT_LE(whole().eventsAt[trip.state().tick - 1], index);
    }
  }
  ASSERT_TRUE(trip.go(towardsEvent(trip.driver.run, count - 1)));
  EXPECT_FALSE(trip.go(towardsEvent(trip.driver.run, count)));
}

TEST(Driver, GoesToTheBeginningOfAStage) {
  Trip trip(support::start(frame()));
  for (const Stage stage :
       {Stage::refine, Stage::step2, Stage::carve, Stage::constraints, Stage::step5, Stage::step2}) {
    ASSERT_TRUE(trip.go(towardsStage(trip.driver.run, stage)));
    EXPECT_EQ(trip.state().stage, stage);
    EXPECT_FALSE(trip.state().cursor.begun);
    if (stage == Stage::step2) {
      EXPECT_EQ(trip.state().round, 1);
    }
  }
  ASSERT_TRUE(trip.go({.kind = Goal::Kind::end}));
  EXPECT_EQ(hashOf(trip.state()), hashOf(support::finished(frame())));
}

TEST(Driver, BackUndoesForwardByEachGrain) {
  for (const Grain grain : {Grain::decision, Grain::insertion, Grain::stage}) {
    Trip trip(support::start(frame()), kFewBytes);
    ASSERT_TRUE(trip.go(towardsStage(trip.driver.run, Stage::step1)));
    std::vector<std::uint64_t> places{trip.state().tick};
    for (int k = 0; k < 5; ++k) {
      trip.go(forward(trip.driver.run, grain));
      if (trip.state().tick > places.back()) places.push_back(trip.state().tick);
    }
    ASSERT_GT(places.size(), 2u);
    for (std::size_t k = places.size() - 1; k-- > 1;) {
      ASSERT_TRUE(trip.go(back(trip.driver.run, grain)));
      EXPECT_EQ(trip.state().tick, places[k]);
      // At the end of a stage a run stands in the next one, after the same decisions.
      if (grain != Grain::stage) {
        EXPECT_EQ(hashOf(trip.state()), whole().hashAt[places[k]]);
      }
    }
  }
}

TEST(Driver, HitsForwardsAreTheHitsBackwardsReversed) {
  Result<Condition> condition = Condition::compile("inserted and stage == step1");
  ASSERT_TRUE(condition.ok());
  Trip trip(support::start(frame()), kFewBytes);
  trip.driver.breakpoints = {{*condition}};
  std::vector<std::uint64_t> forwards;
  while (trip.go({.kind = Goal::Kind::breakpoint}) && trip.driver.stopped) {
    const Hit hit = *trip.driver.stopped;
    EXPECT_EQ(hit.tick, trip.state().tick);
    forwards.push_back(hit.number);
    EXPECT_EQ(trip.log[hit.number].vertex, hit.event.vertex);
  }
  ASSERT_GT(forwards.size(), 3u);
  EXPECT_EQ(trip.driver.run.hits.size(), forwards.size());
  EXPECT_TRUE(isOver(trip.driver.run));
  while (const auto hit = continueBackward(trip.driver.run.history, trip.state().tick, trip.driver.breakpoints)) {
    ASSERT_FALSE(forwards.empty());
    EXPECT_EQ(hit->number, forwards.back());
    ASSERT_TRUE(trip.go(towardsTick(trip.driver.run, hit->tick)));
    EXPECT_EQ(hashOf(trip.state()), whole().hashAt[hit->tick]);
    forwards.pop_back();
  }
  EXPECT_TRUE(forwards.empty());
}

TEST(Driver, WhatFollowsTheLastDecisionCanBeMet) {
  Result<Condition> condition = Condition::compile("event == stage_finished and stage == optimise");
  ASSERT_TRUE(condition.ok());
  Trip trip(support::start(frame()));
  trip.driver.breakpoints = {{*condition}};
  trip.go({.kind = Goal::Kind::breakpoint});
  ASSERT_TRUE(trip.driver.stopped.has_value());
  EXPECT_EQ(trip.driver.stopped->number, whole().events.size() - 1);
}

TEST(Driver, LooksUpWhenItIsTold) {
  Trip trip(support::start(support::domainAt(support::samples() / "l_shape.json")));
  headFor(trip.driver, {.kind = Goal::Kind::end});
  std::vector<Event> fresh;
  carryOn(trip.driver, 2000, {}, fresh);
  EXPECT_FALSE(isThere(trip.driver));
  EXPECT_LE(trip.state().tick, 2000u);
  EXPECT_GT(trip.state().tick, 1000u);
}

TEST(Run, ACopyGoesItsOwnWay) {
  Trip one(support::start(frame()), kFewBytes);
  ASSERT_TRUE(one.go(towardsStage(one.driver.run, Stage::step2)));
  Trip other = one;
  ASSERT_TRUE(other.go({.kind = Goal::Kind::end}));
  EXPECT_EQ(one.state().stage, Stage::step2);
  EXPECT_EQ(one.driver.run.known, one.driver.run.events);
  ASSERT_TRUE(one.go({.kind = Goal::Kind::end}));
  EXPECT_EQ(hashOf(one.state()), hashOf(other.state()));
}

// What takes a change back is the run from before: nothing of it may have been touched.
TEST(Run, ABranchLeavesTheRunItCameFromAlone) {
  Trip before(support::start(frame()), kFewBytes);
  ASSERT_TRUE(before.go({.kind = Goal::Kind::end}));
  Settings settings;
  settings.omega = 0.05;
  Trip after(support::start(frame()));
  after.driver.run = branchOf(before.driver.run, settings);
  EXPECT_EQ(after.state().stage, Stage::refine);
  ASSERT_TRUE(after.go({.kind = Goal::Kind::end}));
  MeshState straight = support::start(frame(), settings);
  Journal nobody;
  advance(straight, Grain::all, nobody);
  EXPECT_EQ(hashOf(after.state()), hashOf(straight));
  for (const std::uint64_t tick : {after.state().tick / 2, std::uint64_t{3}}) {
    ASSERT_TRUE(before.go(towardsTick(before.driver.run, tick)));
    EXPECT_EQ(hashOf(before.state()), whole().hashAt[tick]);
    ASSERT_TRUE(after.go(towardsTick(after.driver.run, tick)));
    ASSERT_EQ(after.state().tick, tick);
  }
}

}  // namespace
}  // namespace triscope::driver_test
