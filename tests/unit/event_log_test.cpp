// The packed log gives back every event as it was, wherever it is read, cut and continued.
#include "core/run/event_log.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <vector>

#include "core/run/events.h"
#include "support/random.h"
#include "support/runs.h"

namespace triscope::event_log_test {
namespace {

using support::Random;

std::vector<Event> eventsOf(const std::string& sample) {
  std::vector<Event> events;
  MeshState state = support::start(support::domainAt(support::samples() / (sample + ".json")));
  Journal journal{&events};
  while (advance(state, Grain::all, journal)) {
  }
  return events;
}

/// Long enough for blocks of every stage, and for passes of step 6 that link far back.
const std::vector<Event>& longRun() {
  static const std::vector<Event> events = eventsOf("cylinder");
  return events;
}

void expectSame(const EventLog& log, const std::vector<Event>& events) {
  ASSERT_EQ(log.size(), events.size());
  for (std::size_t k = 0; k < events.size(); ++k) ASSERT_TRUE(sameContent(log[k], events[k])) << "event " << k;
}

/// An event that no run would make: any member may be anything.
Event anything(Random& random) {
  const auto id = [&] {
    const std::uint32_t ids[] = {kNoId,
                                 0,
                                 1,
                                 kNoId - 1,
                                 static_cast<std::uint32_t>(random.below(50)),
                                 static_cast<std::uint32_t>(random.next())};
    return ids[random.below(6)];
  };
  const auto number = [&] {
    using Limits = std::numeric_limits<double>;
    const double numbers[] = {0.0,
                              -0.0,
                              1.0,
                              -1.0,
                              Limits::quiet_NaN(),
                              Limits::infinity(),
                              Limits::denorm_min(),
                              Limits::max(),
                              random.between(-2.0, 2.0),
                              random.between(1.9, 2.1)};
    return numbers[random.below(10)];
  };
  Event e;
  e.kind = static_cast<EventKind>(random.below(static_cast<std::size_t>(EventKind::failure) + 1));
  e.stage = static_cast<Stage>(random.below(kStageCount));
  e.rule = static_cast<Rule>(random.below(kRuleCount));
  e.refusal = static_cast<Refusal>(random.below(kRefusalCount));
  e.round = static_cast<std::uint16_t>(random.next() >> (random.below(2) * 15));
  e.removedCount = static_cast<std::uint16_t>(random.next() >> (random.below(2) * 15));
  e.subject = id();
  e.other = id();
  e.vertex = id();
  e.created = id();
  e.createdCount = id();
  e.measured = number();
  e.limit = number();
  e.at = {number(), number()};
  e.from = {number(), number()};
  return e;
}

TEST(EventLog, GivesBackARunBitByBit) {
  for (const char* sample : {"blunt_body", "step", "narrow_gap", "cracked_plate"})
    expectSame(EventLog(eventsOf(sample)), eventsOf(sample));
  expectSame(EventLog(longRun()), longRun());
}

TEST(EventLog, CanBeReadInAnyOrder) {
  const EventLog log(longRun());
  for (std::size_t k = log.size(); k-- > 0;) ASSERT_TRUE(sameContent(log[k], longRun()[k])) << k;
  Random random{7};
  for (int n = 0; n < 2000; ++n) {
    const std::size_t k = random.below(log.size());
    ASSERT_TRUE(sameContent(log[k], longRun()[k])) << k;
    Event without = longRun()[k];
    Event peeked = log.peek(k);
    without.from = peeked.from = {};
    ASSERT_TRUE(sameContent(peeked, without)) << k;
  }
}

TEST(EventLog, KeepsWhatNoRunWouldMake) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random{seed};
    std::vector<Event> events;
    std::map<std::uint32_t, Point> places;
    for (std::size_t k = random.below(5000); k > 0; --k) {
      Event e = anything(random);
      if (!events.empty() && random.below(2) == 0) {
        e.kind = random.below(2) == 0 ? EventKind::vertex_moved : EventKind::vertex_kept;
        e.vertex = events[random.below(events.size())].vertex;
      }
      const bool moves = e.kind == EventKind::vertex_moved || e.kind == EventKind::vertex_kept;
      // What every run keeps to: a vertex moves from where it is.
      if (const auto is = places.find(e.vertex); moves && is != places.end()) e.from = is->second;
      if (e.kind == EventKind::vertex_inserted || e.kind == EventKind::edge_split || e.kind == EventKind::vertex_moved)
        places[e.vertex] = e.at;
      events.push_back(e);
    }
    expectSame(EventLog(events), events);
  }
}

TEST(EventLog, CanBeCutAndContinued) {
  const std::vector<Event>& run = longRun();
  Random random{3};
  EventLog log;
  std::vector<Event> kept;
  for (int n = 0; n < 60; ++n) {
    const std::size_t more = std::min(run.size() - kept.size(), random.below(4000));
    const std::vector<Event> next(run.begin() + static_cast<std::ptrdiff_t>(kept.size()),
                                  run.begin() + static_cast<std::ptrdiff_t>(kept.size() + more));
    log.append(next);
    kept.insert(kept.end(), next.begin(), next.end());
    if (!kept.empty()) (void)log[random.below(kept.size())];  // unpacks a block, which must be forgotten when it is cut
    const std::size_t left = kept.size() - std::min(kept.size(), random.below(3000));
    log.truncate(left);
    kept.resize(left);
    ASSERT_EQ(log.size(), left);
    if (left == 0) continue;
    const std::size_t look = random.below(left);
    ASSERT_TRUE(sameContent(log[look], kept[look])) << look;
  }
  expectSame(log, kept);
  // Going back and doing the same again must not cost what has been saved.
  log.truncate(0);
  log.append(run);
  const std::size_t straight = EventLog(run).bytes();
  log.truncate(run.size() / 2);
  log.append(std::span(run).subspan(run.size() / 2));
  expectSame(log, run);
  EXPECT_LE(log.bytes(), straight + straight / 50);
  EXPECT_LT(straight, run.size() * sizeof(Event) / 2);
}

TEST(EventLog, FindsWhereTwoPart) {
  const std::vector<Event>& run = longRun();
  const EventLog log(run);
  EXPECT_EQ(commonLength(log, log), run.size());
  EXPECT_EQ(commonLength(log, EventLog()), 0u);
  EXPECT_EQ(commonLength(log, EventLog(std::span(run).first(5000))), 5000u);
  for (const std::size_t changed :
       {std::size_t{0}, std::size_t{1023}, std::size_t{1024}, run.size() / 2, run.size() - 1}) {
    std::vector<Event> other = run;
    other[changed].measured += 1.0;
    EXPECT_EQ(commonLength(log, EventLog(other)), changed);
    EXPECT_EQ(commonLength(EventLog(other), log), changed);
  }
}

TEST(Events, AreAViewOfALogOrAList) {
  const EventLog log(longRun());
  for (const Events& events : {Events(log), Events(longRun())}) {
    EXPECT_EQ(events.size(), longRun().size());
    EXPECT_EQ(events.first(10).size(), 10u);
    EXPECT_EQ(events.first(events.size() + 1).size(), events.size());
    EXPECT_TRUE(sameContent(events.first(3000)[2999], longRun()[2999]));
    EXPECT_EQ(events.peek(2999).vertex, longRun()[2999].vertex);
  }
  EXPECT_TRUE(Events().empty());
}

}  // namespace
}  // namespace triscope::event_log_test
