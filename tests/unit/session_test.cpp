// A session gives what the pipeline gives, however it is stepped, and never blocks on what it was asked.
#include "core/session.h"

#include <gtest/gtest.h>

#include <chrono>

#include "core/domain/read.h"
#include "core/pipeline.h"

namespace triscope {
namespace {

using std::chrono::seconds;

constexpr auto kForever = seconds(60);

std::shared_ptr<const Domain> square(double minEdge) {
  Result<Domain> domain = parseDomain(
      R"({"name": "square", "outer": [[0,0],[8,0],[8,8],[0,8]], "holes": [[[3,3],[5,3],[5,5],[3,5]]]})", "square.json");
  EXPECT_TRUE(domain.ok());
  domain->minEdgeLength = minEdge;
  return std::make_shared<const Domain>(std::move(*domain));
}

MeshState straightRun(std::shared_ptr<const Domain> domain, const Settings& settings, std::vector<Event>* events) {
  MeshState state = *begin(std::move(domain), settings);
  Journal journal{events};
  advance(state, Grain::all, journal);
  return state;
}

/// Carries out a command and waits for it to be over.
const Snapshot& doNow(Session& session, const Command& command) {
  session.apply(command);
  EXPECT_TRUE(session.settle(kForever));
  return *session.current();
}

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
  EXPECT_EQ(session.current()->state.counts[static_cast<std::size_t>(Stage::step1)].decisions, 0u);
  doNow(session, command::Restart{});
  EXPECT_EQ(session.current()->state.tick, 0u);
  EXPECT_TRUE(session.events().empty());
}

TEST(Session, AChangeOfSettingsGivesTheMeshOfAFreshRun) {
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

TEST(Session, AChangeInTheMiddleStaysAtTheSameDecision) {
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

TEST(Session, ACancelledChangeKeepsMeshSettingsAndTheWayBack) {
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

TEST(Session, PlayingMakesProgressUntilItIsPaused) {
  Session session;
  doNow(session, command::OpenDomain{square(0.25)});
  doNow(session, command::Restart{});
  session.apply(command::Play{500.0});
  while (session.current()->state.tick < 20) {
    session.settle(std::chrono::milliseconds(5));
    ASSERT_EQ(session.progress().activity, Activity::playing);
  }
  doNow(session, command::Pause{});
  EXPECT_EQ(session.progress().activity, Activity::idle);
  EXPECT_NE(session.current()->state.stage, Stage::finished);
}

TEST(Session, AFileThatCannotBeReadLeavesEverythingAsItWas) {
  Session session;
  const std::uint64_t before = hashOf(doNow(session, command::OpenDomain{square(0.5)}).state);
  doNow(session, command::OpenFile{"/nowhere/at/all.json"});
  ASSERT_TRUE(session.error().has_value());
  EXPECT_EQ(session.error()->code, ExitCode::no_input);
  EXPECT_EQ(hashOf(session.current()->state), before);
  doNow(session, command::StepBack{Grain::decision});
  EXPECT_FALSE(session.error().has_value());
}

TEST(Session, ASettingThatCannotBeMetIsRefusedAndUndone) {
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

TEST(Session, CommandsBeforeAnythingIsOpenDoNothing) {
  Session session;
  session.apply(command::Advance{Grain::all});
  session.apply(command::Restart{});
  EXPECT_TRUE(session.settle(kForever));
  EXPECT_EQ(session.current(), nullptr);
}

}  // namespace
}  // namespace triscope
