// A domain's hash changes with everything that the domain is made of.
#include "core/domain/domain_hash.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>

#include "support/domains.h"

namespace triscope::domain_hash_test {
namespace {

TEST(DomainHash, ChangesWithEveryPartOfTheDomain) {
  const Domain domain = *support::domainFrom(support::kRound);
  const auto spline = static_cast<std::size_t>(std::ranges::find(domain.curves, CurveKind::spline, &Curve::kind) -
                                               domain.curves.begin());
  ASSERT_LT(spline, domain.curves.size());
  const std::vector<std::function<void(Domain&)>> edits{
      [](Domain& d) { d.name += "!"; },
      [](Domain& d) { d.minEdgeLength *= 2.0; },
      [](Domain& d) { d.bounds.hi.x += 1.0; },
      [](Domain& d) { d.loops[1].name += "!"; },
      [](Domain& d) { d.loops[1].role = LoopRole::chain; },
      [](Domain& d) { d.curves[0].b.y += 1.0; },
      [](Domain& d) { d.curves[0].centre.x += 1.0; },
      [](Domain& d) { d.curves[0].radius += 1.0; },
      [](Domain& d) { d.curves[0].startAngle += 1.0; },
      [](Domain& d) { d.curves[0].sweptAngle += 1.0; },
      [spline](Domain& d) { d.curves[spline].knots[1].x += 1.0; },
      [spline](Domain& d) { d.curves[spline].slopes[1].x += 1.0; },
      [spline](Domain& d) { d.curves[spline].params[1] += 0.01; },
      [](Domain& d) { d.density.push_back({.at = {1.0, 1.0}, .length = 0.5}); },
      [](Domain& d) { d.density.push_back({.at = {1.0, 1.0}, .rank = 2}); },
  };
  std::set<std::uint64_t> hashes{hashOf(domain)};
  for (const auto& edit : edits) {
    Domain edited = domain;
    edit(edited);
    hashes.insert(hashOf(edited));
  }
  EXPECT_EQ(hashes.size(), edits.size() + 1);
}

TEST(DomainHash, IsTheSameWhereverTheDomainWasReadFrom) {
  const Domain domain = *support::domainFrom(support::kRound);
  Domain elsewhere = domain;
  elsewhere.file = "elsewhere.json";
  elsewhere.text += "\n";
  EXPECT_EQ(hashOf(elsewhere), hashOf(domain));
}

}  // namespace
}  // namespace triscope::domain_hash_test
