// Edits tried on a small mesh: judged as the whole mesh would be, and taken back to the last byte.
#include "core/mesh/trial.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/mesh/patch.h"
#include "support/edits.h"
#include "support/meshes.h"
#include "support/runs.h"

namespace triscope::trial_test {
namespace {

using support::Random;

class TrialOf : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Domains, TrialOf, testing::Values(support::kRound, support::kNotched, support::kCrackedFrame));

TEST_P(TrialOf, JudgesLikeTheWholeMeshAndTakesBack) {
  // After the fronts alone many bounds are broken.
  MeshState state = support::after(support::domainFrom(GetParam()), Stage::front2);
  const std::vector<Slot> live = support::liveSlots(state.mesh);
  Random random{71};
  Trial trial;
  Patch patch;
  support::EditCounts counts;
  int broken = 0;
  for (int k = 0; k < 120; ++k) {
    extractPatch(state.mesh, live[random.below(live.size())], 4, patch);
    beginTrial(trial, patch.mesh);
    for (int edit = 0; edit < 25; ++edit) {
      trial.mesh.touched->clear();
      std::swap(state.mesh, trial.mesh);
      const std::string tried = support::editAtRandom(state, random, counts);
      std::swap(state.mesh, trial.mesh);
      const Breach judged = judgeEdit(trial, std::numeric_limits<int>::max());
      const Badness whole = badnessOf(trial.mesh, support::liveSlots(trial.mesh));
      ASSERT_EQ(judged.broken, whole.broken) << tried;
      ASSERT_NEAR(judged.excess, whole.excess, 1e-9 * whole.excess) << tried;
      if (!trial.mesh.touched->empty()) {
        ASSERT_GE(judged.shortest, whole.shortest) << tried;
        ASSERT_EQ(std::min(judged.shortest, trial.whole.shortest), std::min(whole.shortest, trial.whole.shortest));
      }
      // Given up early, it is at least as bad as was allowed.
      const int most = whole.broken / 2;
      ASSERT_GE(judgeEdit(trial, most).broken, std::min(whole.broken, most + 1)) << tried;
      broken += whole.broken;
      if (edit % 10 == 9) {
        keepEdit(trial);
        continue;
      }
      takeBack(trial);
      ASSERT_EQ(support::difference(trial.mesh, trial.unedited), "") << tried;
    }
  }
  EXPECT_GT(broken, 0);
  EXPECT_GT(counts.inserted, 10);
  EXPECT_GT(counts.moved, 10);
  EXPECT_GT(counts.removed, 5);
  EXPECT_GT(counts.split, 5);
}

}  // namespace
}  // namespace triscope::trial_test
