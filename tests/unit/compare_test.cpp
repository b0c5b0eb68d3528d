// Two runs side by side: where they part, what differs, and which place stands for which.
#include "core/study/compare.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "core/session/session.h"
#include "support/domains.h"

namespace triscope::compare_test {
namespace {

using namespace std::chrono_literals;
using support::domainAt;

/// A finished run.
struct FinishedRun {
  Session session;
  explicit FinishedRun(const Settings& settings) {
    session.apply(command::Load{domainAt(support::samples() / "annulus.json"), settings, {}});
    EXPECT_TRUE(session.settle(60s));
  }
  [[nodiscard]] const EventLog& events() const { return session.runEvents(); }
  [[nodiscard]] const RunRecord& record() const { return session.record(); }
  RunPlace goTo(const Command& where) {
    session.apply(where);
    EXPECT_TRUE(session.settle(60s));
    const Snapshot& now = *session.current();
    return {now.state.stage, now.state.tick, now.events};
  }
};

Settings withOmega(double omega) {
  Settings settings;
  settings.omega = omega;
  return settings;
}

TEST(Compare, EventsAreTheSameByContent) {
  Event event;
  event.kind = EventKind::vertex_moved;
  event.measured = std::numeric_limits<double>::quiet_NaN();
  event.at = {1.0, 2.0};
  EXPECT_TRUE(sameContent(event, event));
  const auto differs = [&event](auto change) {
    Event other = event;
    change(other);
    return !sameContent(event, other) && !sameContent(other, event);
  };
  EXPECT_TRUE(differs([](Event& e) { e.kind = EventKind::vertex_kept; }));
  EXPECT_TRUE(differs([](Event& e) { e.stage = Stage::refine; }));
  EXPECT_TRUE(differs([](Event& e) { e.rule = Rule::laplacian; }));
  EXPECT_TRUE(differs([](Event& e) { e.refusal = Refusal::star_worse; }));
  EXPECT_TRUE(differs([](Event& e) { e.round = 1; }));
  EXPECT_TRUE(differs([](Event& e) { e.removedCount = 1; }));
  EXPECT_TRUE(differs([](Event& e) { e.subject = 1; }));
  EXPECT_TRUE(differs([](Event& e) { e.other = 1; }));
  EXPECT_TRUE(differs([](Event& e) { e.vertex = 1; }));
  EXPECT_TRUE(differs([](Event& e) { e.created = 1; }));
  EXPECT_TRUE(differs([](Event& e) { e.createdCount = 1; }));
  EXPECT_TRUE(differs([](Event& e) { e.measured = 1.0; }));
  EXPECT_TRUE(differs([](Event& e) { e.limit = 1.0; }));
  EXPECT_TRUE(differs([](Event& e) { e.at.y = std::nextafter(2.0, 3.0); }));
  EXPECT_TRUE(differs([](Event& e) { e.from.x = 1.0; }));
}

TEST(Compare, TheFirstDifferenceMayBeThatOneRunEnds) {
  std::vector<Event> a(3);
  std::vector<Event> b = a;
  const auto first = [&] { return firstDifference(EventLog(a), EventLog(b)); };
  EXPECT_EQ(first(), std::nullopt);
  b[1].subject = 7;
  EXPECT_EQ(first(), 1u);
  b = a;
  b.pop_back();
  EXPECT_EQ(first(), 2u);
  std::swap(a, b);
  EXPECT_EQ(first(), 2u);
  EXPECT_EQ(firstDifference({}, {}), std::nullopt);
}

TEST(Compare, OmegaMattersFromTheFirstMoveOn) {
  const FinishedRun a(withOmega(0.05));
  const FinishedRun b(withOmega(0.25));
  const std::optional<std::size_t> first = firstDifference(a.events(), b.events());
  ASSERT_TRUE(first);
  EXPECT_EQ(a.events()[*first].stage, Stage::refine);
  EXPECT_EQ(a.events()[*first].rule, Rule::laplacian);
  const FinishedRun again(withOmega(0.05));
  EXPECT_EQ(firstDifference(a.events(), again.events()), std::nullopt);
}

TEST(Compare, SettingsThatDifferAreListed) {
  Settings a;
  Settings b = a;
  EXPECT_TRUE(differences(a, b).empty());
  b.omega = 0.25;
  b.laplacian = false;
  const std::vector<SettingDifference> list = differences(a, b);
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[0].setting->key, "omega");
  EXPECT_EQ(list[0].a, 0.15);
  EXPECT_EQ(list[0].b, 0.25);
  EXPECT_EQ(list[1].setting->key, "laplacian");
}

TEST(Compare, FiguresSayWhichIsBetter) {
  Quality a;
  a.aspectMax = 3.0;
  a.minAngle = 32.0;
  a.vertices = 10;
  Quality b = a;
  b.aspectMax = 2.5;
  b.minAngle = 31.0;
  b.vertices = 12;
  const std::vector<FigurePair> pairs = figurePairs(a, b);
  const auto better = [&pairs](std::string_view name) {
    return std::find_if(pairs.begin(), pairs.end(), [name](const FigurePair& p) { return p.name == name; })->better;
  };
  EXPECT_EQ(better("worst aspect ratio"), 'b');
  EXPECT_EQ(better("smallest angle"), 'a');
  EXPECT_EQ(better("largest angle"), ' ');
  EXPECT_EQ(better("vertices"), ' ');
}

TEST(Compare, TheSamePlaceStandsForAPlaceBeforeTheFirstDifference) {
  FinishedRun a(withOmega(0.05));
  FinishedRun b(withOmega(0.25));
  const std::optional<std::size_t> first = firstDifference(a.events(), b.events());
  const auto inA = [&](const RunPlace& place) { return counterpart(place, b.record(), a.record(), first); };
  const std::uint64_t refine = firstEntry(b.record(), Stage::refine)->tick;
  for (const std::uint64_t tick : {std::uint64_t{0}, std::uint64_t{1}, refine / 2, refine - 1, refine})
    EXPECT_EQ(inA(b.goTo(command::Seek{tick})).tick, tick);
  const Counterpart entry = inA(b.goTo(command::GoTo{Stage::step1}));
  EXPECT_EQ(entry.begins, Stage::step1);
  EXPECT_EQ(entry.tick, firstEntry(a.record(), Stage::step1)->tick);
  // At the event that differs both have made the same number of decisions, and each tells its own.
  const RunPlace parted = b.goTo(command::SeekEvent{*first});
  EXPECT_EQ(inA(parted).tick, parted.tick);
  a.goTo(command::Seek{parted.tick});
  EXPECT_TRUE(sameContent(*a.session.current()->last, a.events()[*first]));
  EXPECT_FALSE(sameContent(*a.session.current()->last, *b.session.current()->last));
}

TEST(Compare, LaterPlacesGrowTogetherToTheEnd) {
  FinishedRun a(withOmega(0.05));
  FinishedRun b(withOmega(0.25));
  const std::optional<std::size_t> first = firstDifference(a.events(), b.events());
  std::uint64_t last = 0;
  for (std::uint64_t tick = 0; tick <= b.record().ticks; ++tick) {
    const Stage stage = entryAt(b.record(), tick)->stage;
    const std::uint64_t there =
        counterpart({stage, tick, static_cast<std::uint64_t>(b.events().size())}, b.record(), a.record(), first).tick;
    if (stage == Stage::refine) {
      EXPECT_GE(there, last) << tick;
    }
    EXPECT_LE(there, a.record().ticks);
    last = there;
  }
  EXPECT_EQ(last, a.record().ticks);
  const RunPlace end = b.goTo(command::Advance{Grain::all});  // before record(), which it may replace
  EXPECT_EQ(counterpart(end, b.record(), a.record(), first).tick, a.record().ticks);
}

TEST(Compare, ARoundThatTheOtherNeverCameToIsItsLastRoundsEnd) {
  RunRecord from;
  RunRecord to;
  from.stages = {{Stage::step1, 0, 0, 0},   {Stage::step2, 1, 10, 11}, {Stage::step5, 1, 20, 22},
                 {Stage::step2, 2, 30, 33}, {Stage::step5, 2, 40, 44}, {Stage::refine, 0, 50, 55}};
  from.ticks = 100;
  from.complete = to.complete = true;
  to.stages = {
      {Stage::step1, 0, 0, 0}, {Stage::step2, 1, 10, 11}, {Stage::step5, 1, 24, 26}, {Stage::refine, 0, 36, 40}};
  to.ticks = 66;
  const std::optional<std::size_t> first = 13;
  EXPECT_EQ(counterpart({Stage::step2, 35, 39}, from, to, first).tick, 36u);
  EXPECT_EQ(counterpart({Stage::step5, 25, 28}, from, to, first).tick, 30u) << "halfway through step 5";
  EXPECT_EQ(counterpart({Stage::refine, 75, 81}, from, to, first).tick, 51u) << "halfway through step 6";
  const Counterpart refine = counterpart({Stage::refine, 50, 55}, from, to, first);
  EXPECT_EQ(refine.tick, 36u);
  EXPECT_EQ(refine.begins, Stage::refine);
  const Counterpart end = counterpart({Stage::finished, 100, 110}, from, to, first);
  EXPECT_EQ(end.tick, 66u);
  EXPECT_EQ(end.begins, Stage::finished);
  from.complete = false;
  EXPECT_EQ(counterpart({Stage::refine, 60, 66}, from, to, first).tick, 46u) << "decision by decision, the end unknown";
  EXPECT_EQ(counterpart({Stage::step2, 35, 39}, from, {}, first).tick, 0u) << "nothing is known of the other";
}

}  // namespace
}  // namespace triscope::compare_test
