#include "support/bounds_cases.h"

#include "core/quality/quality.h"
#include "support/judge.h"
#include "support/runs.h"

namespace triscope::support {
namespace {

void expectAll(const MeshState& state, double part = 1.0) {
  expectBounds(state);
  expectValid(state.mesh);
  expectFollowsDomain(state);
  expectNoShortEdge(state, part);
}

}  // namespace

void PrintTo(const BoundsCase& bounds, std::ostream* out) { *out << bounds.file.filename().string(); }

MeshState expectPromise(const BoundsCase& bounds) {
  const DomainPtr domain = domainAt(bounds.file);
  if (domain == nullptr) return {};
  Settings settings;
  settings.minEdge = bounds.minEdge;
  MeshState state = start(domain, settings);
  runPast(state, Stage::step5);
  {
    SCOPED_TRACE("steps 1-5");
    EXPECT_EQ(state.stage, Stage::refine);
    expectAll(state);
  }
  {
    SCOPED_TRACE("with step 6");
    runPast(state, Stage::refine);
    EXPECT_EQ(state.stage, Stage::optimise);
    expectAll(state);
    const Quality q = measure(state.mesh);
    EXPECT_LT(static_cast<double>(q.obtuse), 0.01 * static_cast<double>(q.triangles))
        << q.obtuse << " of " << q.triangles << " triangles are obtuse";
  }
  SCOPED_TRACE("optimised");
  MeshState optimised = state;
  runPast(optimised, Stage::optimise);
  EXPECT_EQ(optimised.stage, Stage::finished);
  expectAll(optimised, 0.5);
  EXPECT_LE(measure(optimised.mesh).obtuse, measure(state.mesh).obtuse);
  return state;
}

}  // namespace triscope::support
