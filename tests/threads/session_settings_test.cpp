// What a change of settings does to a session: the mesh of a fresh run with them, at the same place, or as it was when
// the change is given up.
#include <gtest/gtest.h>

#include "support/runs.h"
#include "support/session_driver.h"

namespace triscope::session_settings_test {
namespace {

TEST(SessionSettings, AChangeOfSettingsGivesTheMeshOfAFreshRun) {
  const auto domain = square(0.5);
  Session session;
  doNow(session, command::OpenDomain{domain});
  Settings settings = session.settings();
  settings.omega = 0.22;
  settings.sharedEdge = false;
  EXPECT_EQ(hashOf(doNow(session, command::Change{settings}).state), hashOf(straightRun(domain, settings, nullptr)));
  settings.gapFraction = 0.6;
  EXPECT_EQ(hashOf(doNow(session, command::Change{settings}).state), hashOf(straightRun(domain, settings, nullptr)));
  settings.laplacian = settings.reduceObtuse = false;
  EXPECT_EQ(hashOf(doNow(session, command::Change{settings}).state), hashOf(straightRun(domain, settings, nullptr)));
  settings.laplacian = true;
  EXPECT_EQ(hashOf(doNow(session, command::Change{settings}).state), hashOf(straightRun(domain, settings, nullptr)));
}

/// Opens a domain and goes to where a stage begins; returns the settings in force.
Settings openAt(Session& session, const std::shared_ptr<const Domain>& domain, Stage stage) {
  doNow(session, command::OpenDomain{domain});
  doNow(session, command::GoTo{stage});
  return session.settings();
}

TEST(SessionSettings, WhereAStageBeginsAnotherMeshIsSeenThereToo) {
  const auto domain = square(0.5);
  Session session;
  Settings settings = openAt(session, domain, Stage::optimise);
  for (const double omega : {0.05, 0.25}) {
    settings.omega = omega;
    const Snapshot& now = doNow(session, command::Change{settings});
    EXPECT_EQ(hashOf(now.state), hashOf(support::after(domain, Stage::refine, settings)));
  }
  settings.optimise = false;
  EXPECT_EQ(doNow(session, command::Change{settings}).state.stage, Stage::finished) << "it begins no more";
}

// On the way to where a stage begins, from a keyframe before the stage that the change matters to.
TEST(SessionSettings, AChangeOnTheWayToAStageEndsWhereItBeginsWithIt) {
  const auto domain = support::domainAt(support::samples() / "annulus.json");
  Settings settings;
  settings.refinePasses = 3;  // so that no keyframe lies within step 6
  for (const auto& [from, to] : {std::pair(0.05, 0.25), std::pair(0.25, 0.05)}) {
    Session session;
    settings.omega = from;
    session.apply(command::Load{domain, settings, {}});
    ASSERT_TRUE(session.settle(kForever));
    settings.omega = to;
    session.apply(command::GoTo{Stage::optimise});
    const Snapshot& now = doNow(session, command::Change{settings});
    EXPECT_EQ(hashOf(now.state), hashOf(support::after(domain, Stage::refine, settings)));
  }
}

TEST(SessionSettings, AStageThatIsLeftOutIsMetByTheNextOne) {
  Session session;
  Settings settings = openAt(session, square(0.5), Stage::front1);
  settings.placement = Placement::spokes;
  EXPECT_EQ(doNow(session, command::Change{settings}).state.stage, Stage::rows);
}

TEST(SessionSettings, AChangeWithNoDomainOpenIsForTheNextOne) {
  const auto domain = square(0.5);
  Session session;
  Settings settings;
  settings.omega = 0.22;
  session.apply(command::Change{settings});
  session.settle(kForever);
  EXPECT_EQ(session.settings(), settings);
  EXPECT_EQ(hashOf(doNow(session, command::OpenDomain{domain}).state), hashOf(straightRun(domain, settings, nullptr)));
  EXPECT_EQ(session.notice(), "") << "there was no domain before that they could be kept from";
}

TEST(SessionSettings, WhatIsShownIsStaleAsSoonAsAChangeIsGiven) {
  Session session;
  doNow(session, command::OpenDomain{square(0.5)});
  EXPECT_FALSE(session.stale());
  Settings settings = session.settings();
  settings.omega = 0.22;
  session.apply(command::Change{settings});
  EXPECT_TRUE(session.stale()) << "also before the worker has heard of it";
  session.settle(kForever);
  EXPECT_FALSE(session.stale());
}

TEST(SessionSettings, AChangeBeforeTheFirstDecisionDerivesTheLengthsAgain) {
  const auto domain = square(0.0);
  Session session;
  doNow(session, command::OpenDomain{domain});
  doNow(session, command::Restart{});
  Settings coarser;
  coarser.minEdge = 1.0;
  const Snapshot& now = doNow(session, command::Change{coarser});
  EXPECT_EQ(now.state.tick, 0u);
  EXPECT_EQ(hashOf(now.state), hashOf(*begin(domain, coarser)));
  doNow(session, command::Advance{Grain::all});
  EXPECT_EQ(hashOf(session.current()->state), hashOf(straightRun(domain, coarser, nullptr)));
}

TEST(SessionSettings, ACapOnTheRoundsHoldsAtTheEntryOfALaterOne) {
  const auto domain = square(0.25);
  Session session;
  doNow(session, command::OpenDomain{domain});
  doNow(session, command::Restart{});
  while (session.current()->state.round < 2) doNow(session, command::Advance{Grain::round});
  ASSERT_EQ(session.current()->state.stage, Stage::step2);
  ASSERT_FALSE(session.current()->state.cursor.begun);
  Settings one = session.settings();
  one.maxRounds = 1;
  doNow(session, command::Change{one});
  EXPECT_EQ(hashOf(doNow(session, command::Advance{Grain::all}).state), hashOf(straightRun(domain, one, nullptr)));
}

TEST(SessionSettings, AChangeInTheMiddleStaysAtTheSameDecision) {
  const auto domain = square(0.5);
  Session session;
  doNow(session, command::OpenDomain{domain});
  doNow(session, command::GoTo{Stage::step1});
  const std::uint64_t tick = doNow(session, command::Advance{Grain::insertion}).state.tick;
  Settings settings = session.settings();
  settings.omega = 0.2;  // matters only later
  EXPECT_EQ(doNow(session, command::Change{settings}).state.tick, tick);
  EXPECT_EQ(hashOf(doNow(session, command::Advance{Grain::all}).state), hashOf(straightRun(domain, settings, nullptr)));
}

TEST(SessionSettings, ACancelledChangeKeepsMeshSettingsAndTheWayBack) {
  const auto domain = square(0.5);
  Session session;
  const std::uint64_t before = hashOf(doNow(session, command::OpenDomain{domain}).state);
  const std::size_t events = session.events().size();
  Settings settings = session.settings();
  const Settings old = settings;
  settings.minEdge = 0.01;  // everywhere: more than a million triangles
  settings.maxRank = 1;
  session.apply(command::Change{settings});
  EXPECT_FALSE(session.settle(std::chrono::milliseconds(50)));
  EXPECT_TRUE(session.stale());
  EXPECT_EQ(session.progress().activity, Activity::meshing);
  EXPECT_EQ(session.settings(), settings);
  session.apply(command::Cancel{});
  EXPECT_TRUE(session.settle(kForever));
  EXPECT_FALSE(session.stale());
  EXPECT_EQ(session.settings(), old);
  EXPECT_EQ(hashOf(session.current()->state), before);
  EXPECT_EQ(session.events().size(), events);
  // What follows starts from the mesh that was kept.
  doNow(session, command::StepBack{Grain::stage});
  EXPECT_EQ(hashOf(doNow(session, command::Advance{Grain::all}).state), before);
}

TEST(SessionSettings, ASettingThatCannotBeMetIsRefusedAndUndone) {
  Session session;
  const std::uint64_t before = hashOf(doNow(session, command::OpenDomain{square(0.5)}).state);
  Settings settings = session.settings();
  const Settings old = settings;
  settings.minEdge = 100.0;  // larger than the domain
  doNow(session, command::Change{settings});
  EXPECT_TRUE(session.error().has_value());
  EXPECT_EQ(session.settings(), old);
  EXPECT_EQ(hashOf(session.current()->state), before);
}

TEST(SessionSettings, ACancelledChangeKeepsTheKeyframesOfTheOldRun) {
  Session session;
  const std::uint64_t end = doNow(session, command::OpenDomain{square(0.25)}).state.tick;
  const std::uint64_t there = hashOf(doNow(session, command::Seek{end - 3}).state);
  doNow(session, command::Seek{end});
  const Settings before = session.settings();
  Settings settings = before;
  for (const double omega : {0.1, 0.2, 0.3}) {
    settings.omega = omega;
    settings.gapFraction = omega;
    session.apply(command::Change{settings});
  }
  session.apply(command::Cancel{});
  EXPECT_TRUE(session.settle(kForever));
  if (session.settings() == before) {  // none of them was complete when it was cancelled
    EXPECT_EQ(hashOf(doNow(session, command::Seek{end - 3}).state), there);
    EXPECT_EQ(measured(session).ticks, end);
  }
}

TEST(SessionSettings, KnowsTheEntryOfStep6ForAsLongAsItHolds) {
  const auto domain = square(0.5);
  Session session;
  EXPECT_EQ(session.beforeRefinement(), nullptr);
  doNow(session, command::OpenDomain{domain});
  const auto entry = session.beforeRefinement();
  ASSERT_NE(entry, nullptr);
  EXPECT_EQ(entry->stage, Stage::refine);
  EXPECT_FALSE(entry->cursor.begun);
  MeshState again = *entry;
  Journal nobody;
  advance(again, Grain::all, nobody);
  EXPECT_EQ(hashOf(again), hashOf(session.current()->state));
  // What step 6 alone depends on leaves it, wherever the run stands.
  Settings settings = session.settings();
  settings.omega = 0.2;
  doNow(session, command::Change{settings});
  EXPECT_EQ(session.beforeRefinement(), entry);
  doNow(session, command::Restart{});
  EXPECT_EQ(session.beforeRefinement(), entry);
  // What matters before makes it another, and none until the run has come there.
  settings.step4AreaRatio = 0.0;
  doNow(session, command::Change{settings});
  EXPECT_EQ(session.beforeRefinement(), nullptr);
  doNow(session, command::Advance{Grain::all});
  ASSERT_NE(session.beforeRefinement(), nullptr);
  EXPECT_NE(session.beforeRefinement(), entry);
  // Nothing comes to step 6 where it is switched off.
  settings.laplacian = settings.reduceObtuse = settings.sharedEdge = settings.polish = false;
  doNow(session, command::Change{settings});
  EXPECT_EQ(session.beforeRefinement(), nullptr);
}

TEST(SessionSettings, SaysWhichParametersAnotherDomainKeeps) {
  Session session;
  doNow(session, command::OpenDomain{square(1.0)});
  Settings settings = session.settings();
  settings.omega = 0.2;
  settings.theta = 9.0;
  settings.sharedEdge = false;
  doNow(session, command::Change{settings});
  Domain other = *square(0.5);
  doNow(session, command::OpenDomain{std::make_shared<const Domain>(other)});
  EXPECT_EQ(session.notice(), "") << "the same file, read again";
  other.file = "other.json";
  doNow(session, command::OpenDomain{std::make_shared<const Domain>(other)});
  EXPECT_EQ(session.settings().omega, 0.2);
  EXPECT_EQ(session.notice(),
            "Kept from the domain before: ω = 0.2, θ = 9°, step 6: move shared edges = off. Params sets it back.");
}

}  // namespace
}  // namespace triscope::session_settings_test
