// A session pumped by hand, without its thread: as a program with one thread would.
#include "core/session/session_work.h"

#include <gtest/gtest.h>

#include "support/session_driver.h"

namespace triscope::session_work_test {
namespace {

/// A session, and a viewer that has heard all it told.
struct Pumped {
  SessionWork work;
  Publication heard;
  std::vector<Event> events;
  std::uint64_t tellings = 0;

  Pumped() {
    work.interrupted = [] { return false; };
    work.waits = [](const CommandTest&) { return false; };
    work.tell = [this](Publication news) {
      ++tellings;
      if (news.snapshot) {
        events.resize(static_cast<std::size_t>(news.keepEvents));
        events.insert(events.end(), news.freshEvents.begin(), news.freshEvents.end());
      }
      add(heard, std::move(news));
    };
  }
  Pumped(const Pumped&) = delete;
  Pumped& operator=(const Pumped&) = delete;

  const Snapshot& doNow(const Command& order) {
    obey(work, order);
    while (isUnderWay(work)) carrySlice(work);
    return *heard.snapshot;
  }
};

TEST(SessionWork, MeshesWithoutAThread) {
  const auto domain = square(0.2);
  Pumped pumped;
  const Snapshot& end = pumped.doNow(command::OpenDomain{domain});
  std::vector<Event> events;
  const MeshState straight = straightRun(domain, {}, &events);
  EXPECT_EQ(hashOf(end.state), hashOf(straight));
  EXPECT_EQ(pumped.events.size(), events.size());
  EXPECT_EQ(end.events, events.size());
  while (traceLags(pumped.work)) carryTrace(pumped.work);
  EXPECT_EQ(pumped.heard.record->samples.back().tick, straight.tick);

  EXPECT_EQ(pumped.doNow(command::Seek{straight.tick / 2}).state.tick, straight.tick / 2);
  EXPECT_EQ(pumped.doNow(command::StepBack{}).state.tick, straight.tick / 2 - 1);
}

TEST(SessionWork, AChangeThatIsCancelledLeavesTheRunFromBefore) {
  const auto domain = square(0.1);
  Pumped pumped;
  const std::uint64_t hash = hashOf(pumped.doNow(command::OpenDomain{domain}).state);
  Settings settings;
  settings.step4AreaRatio = 1.0;
  obey(pumped.work, command::Change{settings});
  ASSERT_TRUE(isUnderWay(pumped.work));
  carrySlice(pumped.work);
  EXPECT_TRUE(pumped.heard.stale);
  obey(pumped.work, command::Cancel{});
  EXPECT_FALSE(isUnderWay(pumped.work));
  EXPECT_FALSE(pumped.heard.stale);
  EXPECT_EQ(hashOf(pumped.work.driver.run.state), hash);
  EXPECT_EQ(pumped.work.driver.run.known, pumped.events.size());
  // It can still be gone about in.
  EXPECT_EQ(pumped.doNow(command::Seek{100}).state.tick, 100u);
}

// A short step says little of how long a slice of many takes.
TEST(SessionWork, ShortStepsDoNotMakeLongSlices) {
  Pumped pumped;
  pumped.doNow(command::OpenDomain{square(0.2)});
  pumped.doNow(command::Restart{});
  const std::uint64_t chunk = pumped.work.chunk;
  for (int k = 0; k < 40; ++k) pumped.doNow(command::Advance{});
  EXPECT_LE(pumped.work.chunk, 2 * chunk);
}

Publication with(std::uint64_t keep, std::uint32_t from, std::uint32_t to) {
  Publication p;
  p.snapshot = std::make_shared<Snapshot>();
  p.keepEvents = keep;
  for (std::uint32_t id = from; id < to; ++id) {
    Event event;
    event.subject = id;
    p.freshEvents.push_back(event);
  }
  return p;
}

TEST(Publication, EventsOfASnapshotThatNobodyTookAreStillTold) {
  Publication waiting = with(10, 10, 14);
  add(waiting, with(12, 112, 115));  // back to 12, and another way from there
  EXPECT_EQ(waiting.keepEvents, 10u);
  std::vector<std::uint32_t> ids;
  for (const Event& event : waiting.freshEvents) ids.push_back(event.subject);
  EXPECT_EQ(ids, (std::vector<std::uint32_t>{10, 11, 112, 113, 114}));
  add(waiting, with(5, 205, 206));  // back to before what was told
  EXPECT_EQ(waiting.keepEvents, 5u);
  EXPECT_EQ(waiting.freshEvents.size(), 1u);
  add(waiting, Publication{});  // progress alone
  EXPECT_NE(waiting.snapshot, nullptr);
  EXPECT_EQ(waiting.freshEvents.size(), 1u);
}

}  // namespace
}  // namespace triscope::session_work_test
