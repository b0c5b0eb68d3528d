// The search for constraints is part of the state: it can be stopped, copied and carried on anywhere, and given up.
#include "core/density/constraint_search.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>

#include "core/session.h"
#include "support/runs.h"

namespace triscope {
namespace {

/// A closed wave of so many points, each of which looks across at the others.
std::string wave(int points) {
  std::string text;
  for (int k = 0; k < points; ++k) {
    const double turn = 2.0 * 3.14159265358979 * k / points;
    const double radius = 1.0 + 0.02 * std::sin(60.0 * turn);
    text += fmt::format("{}[{:.12f}, {:.12f}]", k == 0 ? "" : ", ", radius * std::cos(turn), radius * std::sin(turn));
  }
  return R"({"outer": [[-2, -2], [2, -2], [2, 2], [-2, 2]], "holes": [[)" + text + "]]}";
}

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
  const support::DomainPtr domain = support::domainFrom(wave(400));
  int asked = 0;
  const Result<MeshState> state = begin(domain, {}, [&asked](double fraction) {
    EXPECT_GE(fraction, 0.0);
    EXPECT_LE(fraction, 1.0);
    return ++asked < 3;
  });
  ASSERT_FALSE(state.ok());
  EXPECT_EQ(state.error().code, ExitCode::cancelled);
  EXPECT_EQ(asked, 3);
  EXPECT_TRUE(begin(domain, {}, [](double) { return true; }).ok());
}

// Seconds of looking for Δx: the command that waits is not kept waiting for them.
TEST(Session, CancelsWhileTheSmallestEdgeIsLookedFor) {
  const support::DomainPtr domain = support::domainFrom(wave(6000));
  Session session;
  session.apply(command::OpenDomain{domain});
  session.apply(command::Cancel{});
  ASSERT_TRUE(session.settle(std::chrono::seconds(60)));
  EXPECT_EQ(session.current(), nullptr) << "the search was not given up";
  EXPECT_FALSE(session.busy());
  EXPECT_FALSE(session.error().has_value());
}

TEST(Session, CancelsWhileConstraintsAreLookedFor) {
  const support::DomainPtr domain = support::domainFrom(wave(6000));
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
