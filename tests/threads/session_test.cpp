// A session gives what the pipeline gives, however it is stepped, and never blocks on what it was asked.
#include "core/session/session.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/explain/caption.h"
#include "core/run/quality_trace.h"
#include "support/session_driver.h"

namespace triscope::session_test {
namespace {

TEST(Session, MeshesToTheEndLikeThePipeline) {
  const auto domain = square(0.5);
  std::vector<Event> events;
  const MeshState expected = straightRun(domain, {}, &events);
  Session session;
  const Snapshot& now = doNow(session, command::OpenDomain{domain});
  EXPECT_EQ(now.state.stage, Stage::finished);
  EXPECT_EQ(hashOf(now.state), hashOf(expected));
  EXPECT_EQ(session.events().size(), events.size());
  EXPECT_EQ(now.quality.triangles, measure(expected.mesh).triangles);
  EXPECT_FALSE(session.stale());
}

TEST(Session, EveryGrainLeadsToTheSameEnd) {
  const auto domain = square(1.0);
  const std::uint64_t expected = hashOf(straightRun(domain, {}, nullptr));
  for (const Grain grain : {Grain::decision, Grain::insertion, Grain::stage, Grain::round}) {
    Session session;
    doNow(session, command::OpenDomain{domain});
    doNow(session, command::Restart{});
    int steps = 0;
    while (session.current()->state.stage != Stage::finished && ++steps < 20000)
      doNow(session, command::Advance{grain});
    EXPECT_EQ(hashOf(session.current()->state), expected) << static_cast<int>(grain);
  }
}

TEST(Session, SeekingGivesTheStateOfThatTick) {
  const auto domain = square(1.0);
  Session session;
  const std::uint64_t end = doNow(session, command::OpenDomain{domain}).state.tick;
  MeshState forward = *begin(domain, Settings{});
  std::vector<Event> recorded;
  Journal journal{&recorded};
  std::vector<std::uint64_t> hashes{hashOf(forward)};
  while (forward.tick < end) {
    advance(forward, Grain::decision, journal);
    hashes.push_back(hashOf(forward));
  }
  for (std::uint64_t tick = end; tick-- > 0;) {
    if (tick % 7 != 0) continue;
    const Snapshot& now = doNow(session, command::Seek{tick});
    ASSERT_EQ(now.state.tick, tick);
    // At the end of a stage the state may stand before or after the change of stage: one more step settles it.
    doNow(session, command::Advance{Grain::decision});
    ASSERT_EQ(hashOf(session.current()->state), hashes[static_cast<std::size_t>(tick) + 1]) << tick;
  }
}

TEST(Session, StepsBackByDecisionInsertionAndStage) {
  Session session;
  const std::uint64_t end = doNow(session, command::OpenDomain{square(1.0)}).state.tick;
  EXPECT_EQ(doNow(session, command::StepBack{Grain::decision}).state.tick, end - 1);
  const std::size_t events = session.events().size();
  doNow(session, command::GoTo{Stage::step1});
  EXPECT_EQ(session.current()->state.stage, Stage::step1);
  EXPECT_LT(session.events().size(), events);
  doNow(session, command::Advance{Grain::insertion});
  doNow(session, command::Advance{Grain::insertion});
  const std::size_t vertices = session.current()->state.mesh.points.size();
  doNow(session, command::StepBack{Grain::insertion});
  EXPECT_EQ(session.current()->state.mesh.points.size(), vertices - 1);
  doNow(session, command::StepBack{Grain::stage});
  EXPECT_EQ(session.current()->state.stage, Stage::step1);
  EXPECT_EQ(session.current()->state.counts[Stage::step1].decisions, 0u);
  doNow(session, command::Restart{});
  EXPECT_EQ(session.current()->state.tick, 0u);
  EXPECT_TRUE(session.events().empty());
}

TEST(Session, PlayingMakesProgressUntilItIsPaused) {
  Session session;
  doNow(session, command::OpenDomain{square(0.03)});
  doNow(session, command::Restart{});
  session.apply(command::Play{200.0});
  while (session.current()->state.tick < 20) {
    ASSERT_FALSE(session.settle(std::chrono::milliseconds(5))) << "idle while it should play";
  }
  EXPECT_EQ(session.progress().activity, Activity::playing);
  doNow(session, command::Pause{});
  EXPECT_EQ(session.progress().activity, Activity::idle);
  EXPECT_NE(session.current()->state.stage, Stage::finished);
}

TEST(Session, AFileThatCannotBeReadLeavesEverythingAsItWas) {
  Session session;
  const std::uint64_t before = hashOf(doNow(session, command::OpenDomain{square(0.5)}).state);
  doNow(session, command::OpenFile{"/nowhere/at/all.json"});
  ASSERT_TRUE(session.error().has_value());
  EXPECT_EQ(session.error()->kind, ErrorKind::no_input);
  EXPECT_EQ(hashOf(session.current()->state), before);
  doNow(session, command::StepBack{Grain::decision});
  EXPECT_FALSE(session.error().has_value());
}

TEST(Session, CommandsBeforeAnythingIsOpenDoNothing) {
  Session session;
  session.apply(command::Advance{Grain::all});
  session.apply(command::Restart{});
  EXPECT_TRUE(session.settle(kForever));
  EXPECT_EQ(session.current(), nullptr);
}

TEST(Session, GoingBackForgetsNothingOfTheRun) {
  Session session;
  const std::uint64_t end = doNow(session, command::OpenDomain{square(0.5)}).state.tick;
  const EventLog events = session.runEvents();
  EXPECT_EQ(session.record().ticks, end);
  EXPECT_TRUE(session.record().complete);
  doNow(session, command::Restart{});
  EXPECT_TRUE(session.events().empty());
  EXPECT_EQ(session.runEvents().size(), events.size());
  EXPECT_EQ(session.record().ticks, end);
  for (const std::uint64_t tick : {end / 2, end / 3, end - 1, end}) {
    const Snapshot& now = doNow(session, command::Seek{tick});
    ASSERT_EQ(now.state.tick, tick);
    ASSERT_TRUE(now.last.has_value());
    EXPECT_EQ(captionOf(*now.last), captionOf(events[static_cast<std::size_t>(now.events) - 1]));
  }
  EXPECT_EQ(session.runEvents().size(), events.size());
}

TEST(Session, RecordsWhereStagesBeginAndTheWorstMeasures) {
  Session session;
  const Quality end = doNow(session, command::OpenDomain{square(0.5)}).quality;
  const RunRecord& record = measured(session);
  ASSERT_FALSE(record.stages.empty());
  EXPECT_EQ(record.stages.front().stage, Stage::constraints);
  for (std::size_t k = 1; k < record.stages.size(); ++k) EXPECT_GE(record.stages[k].tick, record.stages[k - 1].tick);
  EXPECT_LE(record.samples.size(), QualityTrace::kMostSamples);
  EXPECT_EQ(record.samples.back().triangles, end.triangles);
  EXPECT_NEAR(static_cast<double>(record.samples.back().worst[0]), end.aspectMax, 1e-5);
  const QualitySample middle = record.samples[record.samples.size() / 2];
  const Quality there = doNow(session, command::Seek{middle.tick}).quality;
  EXPECT_NEAR(static_cast<double>(middle.worst[0]), there.aspectMax, 1e-4 * there.aspectMax);
}

TEST(Session, ADecisionBelongsToTheStageThatIsShownThere) {
  Session session;
  const std::uint64_t end = doNow(session, command::OpenDomain{square(0.5)}).state.tick;
  const RunRecord record = session.record();
  EXPECT_EQ(entryOfDecision(record, 0)->stage, Stage::constraints);
  for (const StageEntry& border : record.stages) {
    for (const std::uint64_t tick : {border.tick, border.tick + 1}) {
      if (tick == 0 || tick >= end) continue;
      const Snapshot& there = doNow(session, command::Seek{tick});
      const StageEntry* const entry = entryOfDecision(record, tick);
      EXPECT_EQ(entry->stage, there.last->stage) << tick;
      if (entry->stage < Stage::refine) {  // passes are no entries
        EXPECT_EQ(entry->round, there.last->round) << tick;
      }
    }
  }
}

TEST(Session, ASampleOfASnapshotEqualsTheTraces) {
  Session session;
  doNow(session, command::OpenDomain{square(0.5)});
  const QualitySample traced = measured(session).samples[session.record().samples.size() / 2];
  const Snapshot& there = doNow(session, command::Seek{traced.tick});
  const QualitySample own = sampleOf(there.state.tick, there.quality);
  EXPECT_EQ(own.tick, traced.tick);
  EXPECT_EQ(own.triangles, traced.triangles);
  EXPECT_EQ(own.obtuse, traced.obtuse);
  for (std::size_t m = 0; m < own.worst.size(); ++m) EXPECT_FLOAT_EQ(own.worst[m], traced.worst[m]) << m;
}

TEST(Session, SeeksAnEvent) {
  Session session;
  doNow(session, command::OpenDomain{square(0.5)});
  for (std::size_t index = 0; index + 1 < session.runEvents().size(); index += 13) {
    doNow(session, command::SeekEvent{index});
    const std::uint64_t after = session.current()->events;
    ASSERT_GT(after, index);
    doNow(session, command::StepBack{Grain::decision});
    ASSERT_LE(session.current()->events, index);
  }
}

TEST(Session, ContinuesToABreakpointBothWays) {
  Session session;
  const std::uint64_t end = doNow(session, command::OpenDomain{square(0.5)}).state.tick;
  doNow(session, command::SetBreakpoints{{{*Condition::compile("stage == step1 and inserted")}}});
  doNow(session, command::Restart{});
  std::vector<std::uint64_t> forwards;
  for (doNow(session, command::Continue{}); session.current()->state.tick < end; doNow(session, command::Continue{}))
    forwards.push_back(session.current()->state.tick);
  ASSERT_GT(forwards.size(), 3u);
  EXPECT_EQ(session.hits().size(), forwards.size());
  EXPECT_FALSE(session.notice().empty());
  std::vector<std::uint64_t> backwards;
  for (std::uint64_t before = end; doNow(session, command::Continue{true}).state.tick < before;
       before = session.current()->state.tick)
    backwards.push_back(session.current()->state.tick);
  std::reverse(backwards.begin(), backwards.end());
  EXPECT_EQ(forwards, backwards);
}

TEST(Session, SaysOfAConditionThatHoldsAlreadyWhyItIsNotMet) {
  Session session;
  const std::uint64_t end = doNow(session, command::OpenDomain{square(0.5)}).state.tick;
  doNow(session, command::SetBreakpoints{{{*Condition::compile("triangles > 10"), Breakpoint::Action::stop}}});
  doNow(session, command::Seek{end - 3});
  EXPECT_EQ(doNow(session, command::Continue{}).state.tick, end);
  EXPECT_NE(session.notice().find("triangles > 10 held already"), std::string::npos) << session.notice();
}

TEST(Session, MarksWithoutStoppingAndStopsWhenCancelled) {
  Session session;
  const std::uint64_t end = doNow(session, command::OpenDomain{square(0.5)}).state.tick;
  doNow(session,
        command::SetBreakpoints{{{*Condition::compile("refused"), Breakpoint::Action::mark},
                                 {*Condition::compile("triangle == 1 and vertex == 1"), Breakpoint::Action::stop}}});
  doNow(session, command::Restart{});
  EXPECT_EQ(doNow(session, command::Continue{}).state.tick, end);
  EXPECT_EQ(session.notice(), "No breakpoint stopped the run before its end.");
  EXPECT_FALSE(session.hits().empty());
  session.apply(command::Continue{true});
  session.apply(command::Cancel{});
  EXPECT_TRUE(session.settle(kForever));
  EXPECT_EQ(session.current()->state.tick, end);
  EXPECT_FALSE(session.busy());
}

TEST(Session, LoadsADomainWithSettingsAtAPlace) {
  const auto domain = square(0.5);
  Settings settings;
  settings.omega = 0.1;
  const MeshState expected = straightRun(domain, settings, nullptr);
  Session session;
  doNow(session, command::OpenDomain{square(1.0)});
  session.apply(command::Load{domain, settings, 40});
  EXPECT_EQ(session.domain(), domain);
  EXPECT_EQ(session.settings(), settings);
  EXPECT_TRUE(session.settle(kForever));
  EXPECT_EQ(session.current()->state.tick, 40u);
  EXPECT_EQ(session.current()->state.domain, domain);
  EXPECT_EQ(session.record().ticks, expected.tick);
  EXPECT_TRUE(session.record().complete);
  EXPECT_EQ(hashOf(doNow(session, command::Seek{expected.tick + 1}).state), hashOf(expected));
  // Without a place it is the end.
  EXPECT_EQ(hashOf(doNow(session, command::Load{domain, settings, std::nullopt}).state), hashOf(expected));
}

TEST(Session, ACancelledLoadKeepsTheDomainFromBefore) {
  const auto before = square(0.5);
  const auto after = square(0.05);
  Session session;
  const std::uint64_t hash = hashOf(doNow(session, command::OpenDomain{before}).state);
  session.apply(command::Load{after, session.settings(), std::nullopt});
  session.apply(command::Cancel{});
  EXPECT_EQ(session.domain(), after);  // the worker has not spoken yet
  EXPECT_TRUE(session.settle(kForever));
  ASSERT_EQ(session.domain(), session.current()->state.domain);
  if (session.domain() == before) {
    EXPECT_EQ(hashOf(session.current()->state), hash);
  }
}

TEST(Session, ASearchThatIsGivenUpLeavesTheRunWhereItIs) {
  const auto domain = square(0.15);
  Settings settings;
  settings.maxRank = 1;  // fine everywhere
  Session session;
  const std::uint64_t end = doNow(session, command::Load{domain, settings, std::nullopt}).state.tick;
  const std::uint64_t there = hashOf(doNow(session, command::Seek{end / 2}).state);
  for (const Command& search : {Command(command::FindViolation{}), Command(command::Continue{true})}) {
    session.apply(command::SetBreakpoints{{{*Condition::compile("triangle == 1 and vertex == 1")}}});
    session.apply(search);
    session.apply(command::Cancel{});
    EXPECT_TRUE(session.settle(kForever));
    EXPECT_FALSE(session.busy());
    EXPECT_EQ(session.notice(), "The search was stopped.");
    EXPECT_EQ(session.current()->state.tick, end / 2);
    EXPECT_EQ(hashOf(session.current()->state), there);
    EXPECT_EQ(session.record().ticks, end);
  }
  EXPECT_EQ(hashOf(doNow(session, command::Advance{Grain::all}).state), hashOf(straightRun(domain, settings, nullptr)));
}

TEST(Session, TellsTheFirstViolationInWords) {
  Result<Domain> wedge =
      parseDomain(R"({"name": "wedge", "min_edge_length": 0.2, "outer": [[0,0],[10,0],[10,2]]})", "wedge.json");
  ASSERT_TRUE(wedge.ok());
  Session session;
  doNow(session, command::OpenDomain{std::make_shared<const Domain>(std::move(*wedge))});
  const Snapshot& now = doNow(session, command::FindViolation{});
  EXPECT_EQ(session.notice().find(fmt::format("Decision {}: a bound does not hold", now.state.tick)), 0u)
      << session.notice();
  EXPECT_NE(session.notice().find("at the input angle of 11.3° at (0, 0)"), std::string::npos) << session.notice();
  doNow(session, command::OpenDomain{square(0.5)});
  doNow(session, command::FindViolation{});
  EXPECT_EQ(session.notice(), "No rule is broken in the whole run, and no bound once steps 1–5 are over.");
}

}  // namespace
}  // namespace triscope::session_test
