#include "core/event.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace triscope {
namespace {

TEST(EventNames, EveryKindRuleAndRefusalHasItsOwn) {
  std::set<std::string_view> kinds, rules, refusals;
  for (int i = 0; i <= static_cast<int>(EventKind::failure); ++i) kinds.insert(name(static_cast<EventKind>(i)));
  for (int i = 0; i < kRuleCount; ++i) rules.insert(name(static_cast<Rule>(i)));
  for (int i = 0; i < kRefusalCount; ++i) refusals.insert(name(static_cast<Refusal>(i)));
  EXPECT_EQ(kinds.size(), static_cast<std::size_t>(EventKind::failure) + 1);
  EXPECT_EQ(rules.size(), static_cast<std::size_t>(kRuleCount));
  EXPECT_EQ(refusals.size(), static_cast<std::size_t>(kRefusalCount));
  EXPECT_FALSE(kinds.contains("") || rules.contains("") || refusals.contains(""));
}

TEST(EventNames, StandBesideTheirEnumerators) {
  EXPECT_EQ(name(EventKind::cell_ranked), "cell ranked");
  EXPECT_EQ(name(EventKind::failure), "failure");
  EXPECT_EQ(name(Rule::user_request), "user request");
  EXPECT_EQ(name(Rule::second_front), "second front");
  EXPECT_EQ(name(Rule::step3), "step 3");
  EXPECT_EQ(name(Rule::delaunay_flip), "Delaunay flip");
  EXPECT_EQ(name(Refusal::too_close), "too close");
  EXPECT_EQ(name(Refusal::budget_spent), "budget spent");
  EXPECT_EQ(name(Refusal::too_many_triangles), "too many triangles");
}

TEST(EventNames, OnlyNoneNeedsNoWords) {
  for (int i = 1; i < kRuleCount; ++i) EXPECT_FALSE(describe(static_cast<Rule>(i)).empty()) << i;
  for (int i = 1; i < kRefusalCount; ++i) EXPECT_FALSE(describe(static_cast<Refusal>(i)).empty()) << i;
}

TEST(EventNames, UnknownNumbersAreNoCrash) {
  EXPECT_EQ(name(static_cast<Rule>(200)), "");
  EXPECT_EQ(name(static_cast<Refusal>(200)), "");
}

}  // namespace
}  // namespace triscope
