// The promise of the paper's section 3 on real domains: those of the test data, and those that may not be copied.
#include <gtest/gtest.h>

#include "support/bounds_cases.h"
#include "support/domains.h"
#include "support/judge.h"
#include "support/runs.h"

namespace triscope::bounds_elsewhere_test {
namespace {

using support::BoundsCase;

std::string nameOf(const testing::TestParamInfo<BoundsCase>& info) {
  return info.param.file.stem().string() + (info.param.minEdge > 0.0 ? "_coarse" : "");
}

class RealDomains : public testing::TestWithParam<BoundsCase> {};

TEST_P(RealDomains, MeetEveryBound) {
  if (!std::filesystem::exists(GetParam().file)) GTEST_SKIP() << "there is no " << GetParam().file;
  support::expectPromise(GetParam());
}

INSTANTIATE_TEST_SUITE_P(TestData, RealDomains,
                         testing::Values(BoundsCase{support::testData() / "airfoil_naca0012.json"},
                                         BoundsCase{support::testData() / "koch5.json"},
                                         BoundsCase{support::testData() / "eccentric_gap.json"}),
                         nameOf);
INSTANTIATE_TEST_SUITE_P(Elsewhere, RealDomains,
                         testing::Values(BoundsCase{support::elsewhere() / "airfoil_30p30n.json"},
                                         BoundsCase{support::elsewhere() / "airfoil_kt3.json"},
                                         BoundsCase{support::elsewhere() / "airfoil_williams2.json"},
                                         BoundsCase{support::elsewhere() / "airfoil_rae2822.json"},
                                         BoundsCase{support::elsewhere() / "lake_superior.json"},
                                         BoundsCase{support::elsewhere() / "malpasset.json"},
                                         BoundsCase{support::elsewhere() / "nazca_monkey.json"}),
                         nameOf);

// Whatever angles the input has: the mesh is valid, and is that of the domain.
TEST(EveryDomain, GivesAValidMesh) {
  for (const auto& folder : {support::testData(), support::elsewhere()}) {
    if (!std::filesystem::is_directory(folder)) continue;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.path().extension() != ".json") continue;
      SCOPED_TRACE(entry.path().filename().string());
      const MeshState state = support::after(support::domainAt(entry.path()), Stage::step5);
      support::expectValid(state.mesh);
      support::expectFollowsDomain(state);
    }
  }
}

}  // namespace
}  // namespace triscope::bounds_elsewhere_test
