#include "support/bounds_cases.h"

#include "core/quality/quality.h"
#include "support/judge.h"
#include "support/runs.h"

namespace triscope::support {
namespace {

void expectAll(const MeshState& state) {
  expectBounds(state);
  expectValid(state.mesh);
  expectFollowsDomain(state);
  expectNoShortEdge(state);
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
  SCOPED_TRACE("with step 6");
  runPast(state, Stage::refine);
  EXPECT_EQ(state.stage, Stage::finished);
  expectAll(state);
  const Quality q = measure(state.mesh);
  EXPECT_LT(static_cast<double>(q.obtuse), 0.01 * static_cast<double>(q.triangles))
      << q.obtuse << " of " << q.triangles << " triangles are obtuse";
  return state;
}

}  // namespace triscope::support
