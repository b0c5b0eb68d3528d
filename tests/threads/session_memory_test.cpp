// A session that runs out of memory says so, gives back what it took, and can go on.
#include <gtest/gtest.h>

#include <sys/resource.h>
#include <unistd.h>

#include <fstream>
#include <string>

#include "support/session_driver.h"

namespace triscope::session_memory_test {
namespace {

/// While it lives the process may take so many bytes more than it has.
class Room {
 public:
  explicit Room(std::size_t bytes) {
    getrlimit(RLIMIT_AS, &before_);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // which have memory of their own, without end
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    rlimit limit = before_;
    limit.rlim_cur = pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) + bytes;
    set_ = pages > 0 && setrlimit(RLIMIT_AS, &limit) == 0;
#else
    static_cast<void>(bytes);
#endif
  }
  ~Room() { setrlimit(RLIMIT_AS, &before_); }
  Room(const Room&) = delete;
  Room& operator=(const Room&) = delete;
  [[nodiscard]] bool set() const { return set_; }

 private:
  rlimit before_{};
  bool set_ = false;
};

constexpr std::size_t kBytes = 48u << 20u;

/// A million triangles.
std::shared_ptr<const Domain> large() {
  const auto domain = square(0.01);
  Domain even = *domain;
  even.density.push_back(
      {.where = DensityRequest::Where::box, .at = even.bounds.lo, .to = even.bounds.hi, .length = 0.01});
  return std::make_shared<const Domain>(std::move(even));
}

TEST(SessionMemory, ARunThatDoesNotFitIsGivenUpAtItsStart) {
  Session session;
  doNow(session, command::OpenDomain{square(0.5)});
  Session alone;
  {
    const Room room(kBytes);
    if (!room.set()) GTEST_SKIP() << "the memory of a process cannot be limited here";
    alone.apply(command::OpenDomain{large()});
    ASSERT_TRUE(alone.settle(kForever));
    ASSERT_TRUE(alone.error());
    EXPECT_EQ(alone.error()->kind, ErrorKind::no_memory);
    EXPECT_EQ(alone.current()->state.tick, 0u);
    EXPECT_TRUE(alone.events().empty());
    EXPECT_EQ(alone.record().ticks, 0u);
    // The room is there again: for a smaller one it suffices.
    doNow(alone, command::OpenDomain{square(0.5)});
    EXPECT_FALSE(alone.error());
  }
  EXPECT_EQ(hashOf(alone.current()->state), hashOf(session.current()->state));
}

TEST(SessionMemory, AChangeThatDoesNotFitLeavesTheRunFromBefore) {
  Session session;
  const std::uint64_t before = hashOf(doNow(session, command::OpenDomain{square(0.5)}).state);
  const Settings settings = session.settings();
  const std::size_t events = session.events().size();
  {
    const Room room(kBytes);
    if (!room.set()) GTEST_SKIP() << "the memory of a process cannot be limited here";
    Settings finer = settings;
    finer.minEdge = 0.01;
    finer.maxRank = 1;
    doNow(session, command::Change{finer});
    ASSERT_TRUE(session.error());
    EXPECT_EQ(session.error()->kind, ErrorKind::no_memory);
    EXPECT_FALSE(session.stale());
    EXPECT_EQ(session.settings(), settings);
    EXPECT_EQ(session.events().size(), events);
    EXPECT_EQ(hashOf(session.current()->state), before);
    // The room that the change took is there again.
    EXPECT_EQ(doNow(session, command::Restart{}).state.tick, 0u);
    EXPECT_FALSE(session.error());
    doNow(session, command::Advance{Grain::all});
    EXPECT_FALSE(session.error());
  }
  EXPECT_EQ(hashOf(session.current()->state), before);
}

}  // namespace
}  // namespace triscope::session_memory_test
