// A session obeys while the search for the smallest edge, or for constraints, goes on.
#include <gtest/gtest.h>

#include "core/session/session.h"
#include "support/domains.h"
#include "support/wave.h"

namespace triscope {
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
}  // namespace triscope
