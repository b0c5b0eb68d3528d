// The search for constraints is part of the state: it can be stopped, copied and carried on anywhere, and given up.
#include "core/density/constraint_search.h"

#include <gtest/gtest.h>

#include "support/runs.h"
#include "support/wave.h"

namespace triscope::constraint_search_test {
namespace {

TEST(ConstraintSearch, CarriesOnFromAnyCopy) {
  for (const char* json : {support::kCrackedFrame, support::kRound, support::kNotched}) {
    const support::DomainPtr domain = support::domainFrom(json);
    const std::uint64_t whole = hashOf(support::after(domain, Stage::constraints));
    MeshState state = support::start(domain);
    Journal nobody;
    std::uint64_t before = hashOf(state);
    int pieces = 0;
    while (state.tick == 0) {
      ASSERT_TRUE(advanceAPiece(state, nobody));
      EXPECT_NE(hashOf(state), before) << "piece " << pieces << " changed nothing";
      before = hashOf(state);
      MeshState copy = state;
      support::runPast(copy, Stage::constraints);
      EXPECT_EQ(hashOf(copy), whole) << "carried on from piece " << pieces;
      ++pieces;
    }
    EXPECT_GT(pieces, 10);
    EXPECT_TRUE(state.search.found.empty());
  }
}

// The steps along a curve had a least that was above their most, which std::clamp does not allow.
TEST(ConstraintSearch, CurvesMayBeShortBesideTheSmallestEdge) {
  const support::DomainPtr domain = support::domainFrom(R"({"min_edge_length": 1, "outer": [[0,0],[8,0],[8,8],[0,8]],
    "holes": [[[3,3],[5,3],[5,5],[3,5]], {"kind": "circle", "centre": [6.5, 4], "radius": 0.5}]})");
  EXPECT_EQ(support::after(domain, Stage::constraints).stage, Stage::quadtree);
}

TEST(ConstraintSearch, TellsHowFarItIs) {
  const support::DomainPtr domain = support::domainFrom(support::kNotched);
  ConstraintSearch search = searchFor(*domain, 0.07);
  double last = 0.0;
  while (carryOn(search, *domain, Settings{})) {
    EXPECT_GE(fractionOf(search, *domain), 0.0);
    EXPECT_LE(fractionOf(search, *domain), 1.0);
    last = std::max(last, fractionOf(search, *domain));
  }
  EXPECT_GT(last, 0.5);
  EXPECT_EQ(fractionOf(search, *domain), 1.0);
}

TEST(Begin, CanBeGivenUp) {
  const support::DomainPtr domain = support::domainFrom(support::wave(400));
  int asked = 0;
  const Result<MeshState> state = begin(domain, {}, [&asked](double fraction) {
    EXPECT_GE(fraction, 0.0);
    EXPECT_LE(fraction, 1.0);
    return ++asked < 3;
  });
  ASSERT_FALSE(state.ok());
  EXPECT_EQ(state.error().kind, ErrorKind::cancelled);
  EXPECT_EQ(asked, 3);
  EXPECT_TRUE(begin(domain, {}, [](double) { return true; }).ok());
}

}  // namespace
}  // namespace triscope::constraint_search_test
