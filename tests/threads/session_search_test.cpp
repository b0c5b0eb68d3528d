// A session obeys while the search for the smallest edge, or for constraints, goes on.
#include <gtest/gtest.h>

#include "core/session/session.h"
#include "support/domains.h"
#include "support/wave.h"

namespace triscope::session_search_test {
namespace {

// Seconds of looking for Δx: the command that waits is not kept waiting for them.
TEST(SessionSearch, CancelsWhileTheSmallestEdgeIsLookedFor) {
  const support::DomainPtr domain = support::domainFrom(support::wave(6000));
  Session session;
  session.apply(command::OpenDomain{domain});
  session.apply(command::Cancel{});
  ASSERT_TRUE(session.settle(std::chrono::seconds(60)));
  EXPECT_EQ(session.current(), nullptr) << "the search was not given up";
  EXPECT_FALSE(session.busy());
  EXPECT_FALSE(session.error().has_value());
}

// What is ordered meanwhile is for the run to come.
TEST(SessionSearch, OpensWhateverElseIsOrderedWhileTheSmallestEdgeIsLookedFor) {
  const support::DomainPtr domain = support::domainFrom(support::wave(100));
  Settings settings;
  settings.omega = 0.22;
  const std::vector<Command> orders{command::SetBreakpoints{}, command::Change{settings}, command::Pause{},
                                    command::Advance{}, command::GoTo{Stage::quadtree}};
  for (const Command& order : orders) {
    SCOPED_TRACE(order.index());
    Session session;
    session.apply(command::OpenDomain{domain});
    session.apply(order);
    ASSERT_TRUE(session.settle(std::chrono::seconds(60)));
    ASSERT_NE(session.current(), nullptr) << "the domain was not opened";
    EXPECT_EQ(session.domain(), domain);
  }
}

TEST(SessionSearch, OpensAnotherDomainWithAChangeOrderedWhileItsSmallestEdgeIsLookedFor) {
  const support::DomainPtr domain = support::domainFrom(support::wave(100));
  Session session;
  session.apply(command::OpenDomain{support::domainFrom(support::kFrame)});
  ASSERT_TRUE(session.settle(std::chrono::seconds(60)));
  Settings settings = session.settings();
  settings.omega = 0.22;
  session.apply(command::OpenDomain{domain});
  session.apply(command::SetBreakpoints{});
  session.apply(command::Change{settings});
  ASSERT_TRUE(session.settle(std::chrono::seconds(60)));
  EXPECT_EQ(session.current()->state.domain, domain) << "the opening was given up";
  EXPECT_EQ(session.settings(), settings);
}

TEST(SessionSearch, CancelsWhileConstraintsAreLookedFor) {
  const support::DomainPtr domain = support::domainFrom(support::wave(6000));
  auto given = std::make_shared<Domain>(*domain);
  given->minEdgeLength = 1e-4;
  Session session;
  session.apply(command::OpenDomain{given});
  session.apply(command::Cancel{});
  ASSERT_TRUE(session.settle(std::chrono::seconds(60)));
  ASSERT_NE(session.current(), nullptr);
  EXPECT_EQ(session.current()->state.stage, Stage::constraints);
  EXPECT_EQ(session.current()->state.tick, 0u);
}

}  // namespace
}  // namespace triscope::session_search_test
