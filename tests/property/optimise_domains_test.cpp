// On random domains whose angles are 60° or more, at any scale and place, the optimiser leaves no obtuse triangle, and
// a valid mesh of the domain whatever it is asked for.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/quality/quality.h"
#include "support/judge.h"
#include "support/optimised.h"
#include "support/random_domains.h"
#include "support/runs.h"

namespace triscope::optimise_domains_test {
namespace {

using support::Random;
using support::Shape;

struct Leftovers {
  std::size_t meshes = 0;
  std::size_t withObtuse = 0;
  std::size_t obtuse = 0;
};

void optimise(const support::DomainPtr& domain, const Settings& settings, Leftovers& left) {
  const MeshState state = support::finished(domain, settings);
  ASSERT_FALSE(state.failed);
  const double unit = std::max({std::fabs(domain->bounds.lo.x), std::fabs(domain->bounds.hi.y), 0.0}) * 0x1p-52;
  support::expectValid(state.mesh);
  support::expectFollowsDomain(state, 8.0 * unit / std::min(domain->bounds.width(), domain->bounds.height()) + 1e-12);
  const Quality q = measure(state.mesh);
  ++left.meshes;
  // Coarse meshes of a few triangles have no room to be better.
  constexpr std::size_t kRoom = 20;
  left.withObtuse += q.obtuse > 0 && q.triangles >= kRoom ? 1 : 0;
  left.obtuse += q.obtuse;
}

class OptimisedDomains : public testing::TestWithParam<int> {};

INSTANTIATE_TEST_SUITE_P(Shapes, OptimisedDomains, testing::Range(0, support::kShapes));

TEST_P(OptimisedDomains, HaveNoObtuseTriangleFromRows) {
  Leftovers left;
  for (std::uint64_t seed = 1; seed <= 250; ++seed) {
    Random random{seed};
    const std::string text =
        support::randomDomain(random, static_cast<Shape>(GetParam()), support::randomSizeAndPlace(random));
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + text);
    optimise(support::domainFrom(text), support::best(), left);
    if (HasFatalFailure()) return;
  }
  EXPECT_EQ(left.withObtuse, 0u) << "of " << left.meshes << " meshes";
  EXPECT_LE(left.obtuse, 4u);
}

TEST_P(OptimisedDomains, StayValidWhateverIsAskedFor) {
  Leftovers left;
  for (std::uint64_t seed = 1001; seed <= 1060; ++seed) {
    Random random{seed};
    const std::string text =
        support::randomDomain(random, static_cast<Shape>(GetParam()), support::randomSizeAndPlace(random));
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + text);
    Settings settings = seed % 2 == 0 ? support::best() : support::optimised();
    settings.placement = seed % 2 == 0 ? static_cast<Placement>(2 + seed / 2 % 4) : settings.placement;
    settings.dial = static_cast<Dial>(seed % 3);
    settings.lowestAngle = random.below(3) == 0 ? random.between(1.0, 55.0) : 0.0;
    settings.highestAngle = random.below(3) == 0 ? random.between(61.0, 120.0) : 0.0;
    settings.areaRatio = random.below(3) == 0 ? random.between(1.0, 3.0) : 0.0;
    optimise(support::domainFrom(text), settings, left);
    if (HasFatalFailure()) return;
  }
}

}  // namespace
}  // namespace triscope::optimise_domains_test
