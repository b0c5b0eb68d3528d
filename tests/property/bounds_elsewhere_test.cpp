// The promise of the paper's section 3 on real domains: those of the test data, and those that may not be copied.
#include <gtest/gtest.h>

#include "support/bounds_cases.h"
#include "support/domains.h"

namespace triscope {
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
                         testing::Values(BoundsCase{support::testData() / "airfoil_naca0012.json"}), nameOf);
INSTANTIATE_TEST_SUITE_P(Elsewhere, RealDomains,
                         testing::Values(BoundsCase{support::elsewhere() / "airfoil_30p30n.json"},
                                         BoundsCase{support::elsewhere() / "airfoil_kt3.json"},
                                         BoundsCase{support::elsewhere() / "airfoil_williams2.json"},
                                         BoundsCase{support::elsewhere() / "airfoil_rae2822.json"},
                                         BoundsCase{support::elsewhere() / "lake_superior.json"}),
                         nameOf);

}  // namespace
}  // namespace triscope
