// Which loop a curve is part of, and which straight one is the shortest.
#include <gtest/gtest.h>

#include "core/domain/loop_of.h"
#include "core/domain/shortest_line.h"
#include "support/domains.h"

namespace triscope::domain_curves_test {
namespace {

TEST(DomainCurves, EachIsPartOfTheLoopThatListsIt) {
  const auto domain = support::domainFrom(R"({
      "outer": [[0,0],[8,0],[8,8],[0,8]],
      "holes": [{"kind": "circle", "centre": [2,2], "radius": 1}, [[5,5],[6,5],[6,6]]],
      "segments": [[[1,6],[2,6],[2,7]]]})");
  ASSERT_EQ(domain->loops.size(), 4u);
  std::size_t listed = 0;
  for (const Loop& loop : domain->loops) {
    for (std::uint32_t k = 0; k < loop.curveCount; ++k, ++listed)
      EXPECT_EQ(&loopOf(*domain, loop.firstCurve + k), &loop) << loop.name << ", curve " << k;
  }
  EXPECT_EQ(listed, domain->curves.size());
}

TEST(DomainCurves, TheShortestStraightOneIsFoundAmongAllLoops) {
  const auto domain = support::domainFrom(R"({
      "outer": [[0,0],[8,0],[8,8],[0,8]],
      "holes": [{"kind": "circle", "centre": [2,2], "radius": 0.01}, [[5,5],[6,5],[6,5.25]]]})");
  const ShortestLine shortest = shortestLine(*domain);
  EXPECT_DOUBLE_EQ(shortest.length, 0.25);
  EXPECT_EQ(loopOf(*domain, shortest.curve).name, "hole 2");
  EXPECT_EQ(domain->curves[shortest.curve].a.x, 6.0);
}

TEST(DomainCurves, OfArcsAloneNoneIsStraight) {
  const auto domain = support::domainFrom(R"({"outer": {"kind": "circle", "centre": [0,0], "radius": 1}})");
  EXPECT_FALSE(shortestLine(*domain).length < 1e308);
}

}  // namespace
}  // namespace triscope::domain_curves_test
