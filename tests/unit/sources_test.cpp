// What asks for short edges (paper, section 2, Figure 1 a): each source alone, and Δx where none is given.
#include "core/density/sources.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/density/constraint_search.h"
#include "core/geometry/trig.h"
#include "core/quality/quality.h"
#include "core/words/vocabulary.h"
#include "support/judge.h"
#include "support/runs.h"

namespace triscope::sources_test {
namespace {

std::vector<Constraint> allOf(const Domain& domain, const Settings& settings = {}) {
  ConstraintSearch search = searchFor(domain, domain.minEdgeLength);
  while (carryOn(search, domain, settings)) {
  }
  return search.found;
}

std::vector<Constraint> from(Rule source, const std::string& json, const Settings& settings = {}) {
  const support::DomainPtr domain = support::domainFrom(json);
  std::vector<Constraint> all = allOf(*domain, settings);
  std::erase_if(all, [&](const Constraint& c) { return c.source != source; });
  return all;
}

double shortest(const std::vector<Constraint>& constraints) {
  return std::ranges::min(constraints, {}, &Constraint::length).length;
}

TEST(Sources, CurvatureAsksForTheTurnThatOneEdgeMaySpan) {
  const std::string circle = R"({"min_edge_length": 0.01, "outer": [[-9, -9], [9, -9], [9, 9], [-9, 9]],
    "holes": [{"kind": "circle", "centre": [0, 0], "radius": 2}]})";
  for (const double turn : {15.0, 30.0}) {
    Settings settings;
    settings.curvatureTurn = turn;
    const auto constraints = from(Rule::curvature, circle, settings);
    ASSERT_FALSE(constraints.empty());
    for (const Constraint& c : constraints) {
      EXPECT_NEAR(c.length, 2.0 * turn * trig::kDegree, 1e-9);
      EXPECT_NEAR(length(c.at), 2.0, 1e-9);
    }
    // Close enough together that no part of the circle is missed.
    for (int k = 0; k < 64; ++k) {
      const trig::SinCos direction = trig::sinCos(2.0 * trig::kPi * k / 64);
      const Point p{2.0 * direction.cos, 2.0 * direction.sin};
      EXPECT_LE(
          distance(std::ranges::min(constraints, {}, [&](const Constraint& c) { return distance(c.at, p); }).at, p),
          2.0 * turn * trig::kDegree);
    }
  }
}

TEST(Sources, NothingAsksForLessThanTheSmallestEdge) {
  for (const char* const json : {support::kRound, support::kNotched, support::kCrackedFrame}) {
    const support::DomainPtr domain = support::domainFrom(json);
    for (const Constraint& c : allOf(*domain)) {
      if (c.source != Rule::short_edge) {
        EXPECT_GE(c.length, domain->minEdgeLength) << name(c.source);
      }
      EXPECT_TRUE(std::isfinite(c.at.x) && std::isfinite(c.at.y) && std::isfinite(c.length));
    }
  }
}

TEST(Sources, ReentrantCornersAreExtremePointsAndOthersAreNot) {
  const auto corners = from(Rule::corner, R"({"min_edge_length": 0.1,
    "outer": [[0, 0], [8, 0], [8, 4], [4, 4], [4, 8], [0, 8]]})");
  ASSERT_EQ(corners.size(), 1u);
  EXPECT_EQ(corners[0].at, (Point{4, 4}));
  EXPECT_DOUBLE_EQ(corners[0].length, 1.0) << "a quarter of the edges beside it";
  Settings settings;
  settings.cornerTurn = 100.0;
  EXPECT_TRUE(from(Rule::corner, R"({"min_edge_length": 0.1,
    "outer": [[0, 0], [8, 0], [8, 4], [4, 4], [4, 8], [0, 8]]})",
                   settings)
                  .empty());
}

TEST(Sources, EndsOfAChainAreExtremePoints) {
  const auto corners = from(Rule::corner, R"({"min_edge_length": 0.1, "outer": [[0, 0], [8, 0], [8, 8], [0, 8]],
    "segments": [[[2, 4], [4, 4], [6, 4]]]})");
  ASSERT_EQ(corners.size(), 2u);
  EXPECT_EQ(corners[0].at, (Point{2, 4}));
  EXPECT_EQ(corners[1].at, (Point{6, 4}));
}

TEST(Sources, GapsAskForAFractionOfTheirWidth) {
  const std::string channel = R"({"min_edge_length": 0.01, "outer": [[0, 0], [10, 0], [10, 8], [0, 8]],
    "holes": [[[1, 0.5], [9, 0.5], [9, 4], [1, 4]]]})";
  for (const double fraction : {0.2, 0.3}) {
    Settings settings;
    settings.gapFraction = fraction;
    const auto gaps = from(Rule::gap, channel, settings);
    ASSERT_FALSE(gaps.empty());
    EXPECT_NEAR(shortest(gaps), fraction * 0.5, 1e-9);
    EXPECT_TRUE(std::ranges::any_of(gaps, [](const Constraint& c) { return c.at.y > 0.1 && c.at.y < 0.4; }))
        << "the middle of the gap is asked for too";
  }
  EXPECT_TRUE(from(Rule::gap, R"({"min_edge_length": 0.01, "outer": [[0, 0], [8, 0], [8, 8], [0, 8]]})").empty())
      << "sides of a square do not face each other across a narrow place";
}

TEST(Sources, ACornerThatFacesAWallStandsAtAGap) {
  struct Case {
    const char* domain;
    double width;
  };
  for (const Case& c : {Case{R"({"min_edge_length": 0.001, "outer": [[0, 0], [10, 0], [10, 10], [0, 10]],
                               "holes": [[[5, 0.02], [7, 5], [5, 9], [3, 5]]]})",
                             0.02},  // above a wall
                        Case{R"({"min_edge_length": 0.001, "outer": [[0, 0], [10, 0], [10, 10], [7, 10], [5, 0.02],
                               [3, 10], [0, 10]]})",
                             0.02},  // of the outer loop
                        Case{R"({"min_edge_length": 0.001, "outer": [[0, 0], [10, 0], [10, 10], [0, 10]],
                               "holes": [[[2, 5], [4.99, 5], [3, 7]], [[5.01, 5], [8, 5], [7, 3]]]})",
                             0.02},  // facing another corner
                        Case{R"({"min_edge_length": 0.001, "outer": [[0, 0], [10, 0], [10, 10], [0, 10]],
                               "segments": [[[5, 5], [5, 9.98]]]})",
                             0.02}}) {  // the end of a chain
    const auto gaps = from(Rule::gap, c.domain);
    ASSERT_FALSE(gaps.empty()) << c.domain;
    EXPECT_NEAR(shortest(gaps), 0.3 * c.width, 1e-6) << c.domain;
  }
}

TEST(Sources, InputEdgesAskForTheirOwnLengthHoweverShort) {
  const auto edges = from(Rule::short_edge, R"({"min_edge_length": 1,
    "outer": [[0, 0], [8, 0], [8, 4], [7.75, 4.25], [8, 8], [0, 8]]})");
  EXPECT_NEAR(shortest(edges), 0.25 * std::sqrt(2.0), 1e-12);
}

TEST(Sources, ALongThinBoxHasNoHoles) {
  const auto requests = from(Rule::user_request, R"({"min_edge_length": 0.001,
    "outer": [[0, 0], [50, 0], [50, 2], [0, 2]], "density": [{"box": [[0, 0.999], [50, 1.001]], "length": 0.001}]})");
  std::vector<double> across;
  for (const Constraint& c : requests) across.push_back(c.at.x);
  std::ranges::sort(across);
  for (std::size_t k = 1; k < across.size(); ++k) ASSERT_LE(across[k] - across[k - 1], 0.004);
}

TEST(Sources, RequestsReachTheirPointBoxAndLoop) {
  const std::string json = R"({"min_edge_length": 0.1, "outer": [[0, 0], [8, 0], [8, 8], [0, 8]],
    "holes": [{"name": "hub", "kind": "circle", "centre": [6, 6], "radius": 1}],
    "density": [{"at": [2, 2], "length": 0.3}, {"box": [[1, 5], [3, 7]], "length": 0.2}, {"loop": "hub", "rank": 4}]})";
  const MeshState state = support::after(support::domainFrom(json), Stage::density);
  EXPECT_LE(edgeLengthAt(state.tree, {2, 2}), 0.3);
  for (double x = 1.01; x < 3.0; x += 0.198) {
    for (double y = 5.01; y < 7.0; y += 0.198) EXPECT_LE(edgeLengthAt(state.tree, {x, y}), 0.2) << x << ", " << y;
  }
  for (int k = 0; k < 32; ++k) {
    const trig::SinCos direction = trig::sinCos(trig::kPi * k / 16);
    EXPECT_LE(edgeLengthAt(state.tree, {6 + direction.cos, 6 + direction.sin}), 0.2 * (1 + 1e-9));
  }
}

// A kept edge of between Δx and 2Δx cannot be split. To ask for Δx around it left angles of exactly 30° beside it.
TEST(Sources, NothingAsksForLessThanAKeptEdgeCanBeSplitInto) {
  const support::DomainPtr domain = support::domainFrom(R"({"min_edge_length": 0.00010472054098400641,
    "outer": [[0.002143132293515602, 0.0006689109019298722], [-3.932393742201406e-05, 0.0018556407199006655],
      [-0.00163845865215241, 0.0009057068276104514], [0.0009760196732248586, -0.0020138524336814]],
    "segments": [[[-9.340566132995414e-05, 7.187351700215656e-05], [-0.00022555410959975754, 0.0002335485907541619]],
      [[-0.00017269730446101088, -8.720966935556136e-05], [-0.00038774653786529935, -0.00018996666566968234]]]})");
  const Curve& chain = domain->curves[4];
  ASSERT_LT(distance(chain.a, chain.b), 2.0 * domain->minEdgeLength);
  int corners = 0;
  for (const Constraint& c : allOf(*domain)) {
    if (c.at != chain.a && c.at != chain.b) continue;
    EXPECT_DOUBLE_EQ(c.length, distance(chain.a, chain.b)) << name(c.source);
    corners += c.source == Rule::corner ? 1 : 0;
  }
  EXPECT_EQ(corners, 2);
  support::expectBounds(support::after(domain, Stage::step5));
}

TEST(DeriveMinEdge, IsTheFinestThatTheGeometryAsksFor) {
  const auto derived = [](const std::string& json) { return *deriveMinEdge(*support::domainFrom(json), {}); };
  EXPECT_DOUBLE_EQ(derived(R"({"outer": [[0, 0], [8, 0], [8, 8], [0, 8]]})"), 0.2) << "a fortieth of the extent";
  EXPECT_NEAR(derived(R"({"outer": [[0, 0], [8, 0], [8, 8], [0, 8]],
    "holes": [{"kind": "circle", "centre": [4, 4], "radius": 0.01}]})"),
              0.01 * 30 * trig::kDegree, 1e-9);
  const double gap = derived(R"({"outer": [[0, 0], [8, 0], [8, 8], [0, 8]],
    "holes": [[[2, 0.05], [6, 0.05], [6, 4], [2, 4]]]})");
  EXPECT_LE(gap, 0.3 * 0.05 * (1 + 1e-9));
  EXPECT_GT(gap, 0.2 * 0.05);
  // The shortest kept edge takes a whole number of edges of that length.
  const double edge = derived(R"({"outer": [[0, 0], [8, 0], [8, 8], [7.9, 8], [7.9, 7.95], [0, 7.95]]})");
  EXPECT_NEAR(0.05 / edge, std::round(0.05 / edge), 1e-9);
  EXPECT_LE(edge, 0.05 * (1 + 1e-12));
}

TEST(FinestLength, IsHalvedUntilShortInputEdgesFit) {
  const auto finest = [](const std::string& json) {
    const support::DomainPtr domain = support::domainFrom(json);
    return finestLength(*domain, domain->minEdgeLength);
  };
  EXPECT_EQ(finest(R"({"min_edge_length": 1, "outer": [[0, 0], [8, 0], [8, 8], [0, 8]]})"), 1.0);
  EXPECT_EQ(finest(R"({"min_edge_length": 1, "outer": [[0, 0], [8, 0], [8, 8], [7, 8], [7, 7.3], [0, 7.3]]})"), 0.5);
  EXPECT_EQ(finest(R"({"min_edge_length": 1, "outer": [[0, 0], [8, 0], [8, 8], [7, 8], [7, 7.2], [0, 7.2]]})"), 1.0);
}

}  // namespace
}  // namespace triscope::sources_test
