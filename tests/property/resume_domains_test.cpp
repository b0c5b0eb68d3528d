// A run that was stopped and copied at random decisions ends in the same bytes, on random domains.
#include <gtest/gtest.h>

#include "support/random_domains.h"
#include "support/runs.h"

namespace triscope::resume_domains_test {
namespace {

using support::Random;

TEST(ResumeRandomDomains, CopiesEndInTheSameBytes) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random{seed};
    const support::SizeAndPlace placement = support::randomSizeAndPlace(random);
    const std::string text =
        support::randomDomain(random, static_cast<support::Shape>(random.below(support::kShapes)), placement);
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + text);
    const support::DomainPtr domain = support::domainFrom(text);
    const MeshState whole = support::finished(domain);
    std::vector<Event> heard;
    Journal journal{&heard};
    MeshState state = support::start(domain);
    for (int copies = 0; copies < 5; ++copies) {
      const std::uint64_t stop = state.tick + random.below(whole.tick / 4 + 1);
      while (state.tick < stop && advance(state, Grain::decision, journal)) {
      }
      MeshState copy = state;
      Journal nobody;
      const auto grain = static_cast<Grain>(random.below(5));
      while (advance(copy, grain, nobody)) {
      }
      ASSERT_EQ(hashOf(copy), hashOf(whole)) << "copied after " << state.tick << " decisions";
    }
  }
}

}  // namespace
}  // namespace triscope::resume_domains_test
