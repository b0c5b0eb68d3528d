// The running worst against a fresh measurement after every decision.
#include "core/quality/running_quality.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "core/domain/read.h"
#include "core/mesh/change_log.h"
#include "core/method/pipeline.h"
#include "core/quality/quality.h"
#include "support/domains.h"
#include "support/optimised.h"
#include "support/runs.h"

namespace triscope::running_quality_test {
namespace {

void expectSame(const RunningQuality& running, const Mesh& mesh, std::uint64_t tick) {
  const Quality fresh = measure(mesh);
  ASSERT_EQ(running.triangles(), fresh.triangles) << "tick " << tick;
  ASSERT_EQ(running.obtuse(), fresh.obtuse) << "tick " << tick;
  if (fresh.triangles == 0) return;
  ASSERT_EQ(running.worst(Measure::aspect), fresh.aspectMax) << "tick " << tick;
  ASSERT_EQ(running.worst(Measure::edge_ratio), fresh.edgeRatioMax) << "tick " << tick;
  ASSERT_EQ(running.worst(Measure::min_angle), fresh.minAngle) << "tick " << tick;
  ASSERT_EQ(running.worst(Measure::max_angle), fresh.maxAngle) << "tick " << tick;
  ASSERT_DOUBLE_EQ(running.worst(Measure::area_ratio), fresh.areaRatioMax) << "tick " << tick;
  const Slot slot = running.worstSlot(Measure::aspect);
  ASSERT_EQ(measuresOf(mesh, slot)[0], fresh.aspectMax);
}

TEST(RunningQuality, EqualsAFreshMeasurementAfterEveryDecision) {
  for (const Settings& settings : {support::best(Dial::acute), support::optimised(Dial::acute)}) {
    for (const std::string sample : {"annulus", "l_shape"}) {
      Result<Domain> domain = readDomain(std::string(TRISCOPE_SOURCE_DIR) + "/assets/domains/" + sample + ".json");
      ASSERT_TRUE(domain.ok());
      Result<MeshState> state = begin(std::make_shared<const Domain>(std::move(*domain)), settings);
      ASSERT_TRUE(state.ok());
      Journal journal;
      ChangeLog changes(state->mesh);
      RunningQuality running;
      running.reset(state->mesh);
      while (advance(*state, Grain::decision, journal)) {
        running.update(state->mesh, changes.slots());
        changes.clear();
        expectSame(running, state->mesh, state->tick);
        if (HasFatalFailure()) return;
      }
    }
  }
}

TEST(RunningQuality, IsToldOfWhatEditsDoToInnerChainsToo) {
  const support::DomainPtr domain = support::domainFrom(support::kCrackedFrame);
  MeshState state = support::after(domain, Stage::refine, support::optimised(Dial::acute));
  Journal journal;
  ChangeLog changes(state.mesh);
  RunningQuality running;
  running.reset(state.mesh);
  while (advance(state, Grain::decision, journal)) {
    running.update(state.mesh, changes.slots());
    changes.clear();
    expectSame(running, state.mesh, state.tick);
    if (HasFatalFailure()) return;
  }
}

}  // namespace
}  // namespace triscope::running_quality_test
