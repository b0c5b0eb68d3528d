// What repair says of itself, and that it and the steps come to an end.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/mesh/badness.h"
#include "core/mesh/edit.h"
#include "core/words/vocabulary.h"
#include "support/judge.h"
#include "support/meshes.h"
#include "support/runs.h"
#include "support/watch.h"

namespace triscope::repair_test {
namespace {

std::uint16_t roundsOf(const support::DomainPtr& domain) {
  MeshState state = support::start(domain);
  Journal nobody;
  std::uint16_t rounds = 0;
  while (state.stage <= Stage::repair && advance(state, Grain::stage, nobody)) {
    if (state.stage <= Stage::repair) rounds = std::max(rounds, state.round);
  }
  return rounds;
}

// Repair took out what step 4 put in, and step 4 put it back, until the budget of rounds was spent.
TEST(Repair, StepsDoNotPutBackWhatItTakesOut) {
  const support::DomainPtr domain = support::domainFrom(R"({"outer": [[1.77751, 0.270725], [1.549224, 2.611872],
    [-1.191119, 2.679717], [-2.683851, 1.002662], [-1.56301, -1.035102], [0.208374, -2.341199],
    [1.639436, -1.683232]]})");
  EXPECT_LT(roundsOf(domain), 20);
  support::expectBounds(support::after(domain, Stage::step5));
}

// Two vertices taken out side by side: each removal had the steps look at the other's gap again and fill it.
TEST(Repair, StepsDoNotFillAGapBesideANewOne) {
  EXPECT_LT(roundsOf(support::domainAt(support::testData() / "koch5.json")), 20);
}

class RepairOf : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Domains, RepairOf,
                         testing::Values(support::kNotched, "sawtooth_angles.json", "eccentric_gap.json"));

TEST_P(RepairOf, EventsAreWhatHappened) {
  const std::string given = GetParam();
  const bool file = given.ends_with(".json");
  Settings settings;
  settings.step4AreaRatio = 0.0;  // the paper's step 4 leaves more to mend
  MeshState state =
      support::start(file ? support::domainAt(support::testData() / given) : support::domainFrom(given), settings);
  Journal nobody;
  while (state.stage < Stage::repair) advance(state, Grain::stage, nobody);
  int looked = 0;
  support::eachDecision(state, Stage::repair, [&](const MeshState& before, const MeshState& now, auto events) {
    if (events.empty() || events.front().stage != Stage::repair) return;
    ++looked;
    ASSERT_LE(events.size(), 2u);
    for (const Event& event : events) {
      EXPECT_EQ(event.rule, Rule::repair);
      const TriangleId patient(event.kind == EventKind::edge_split ? event.other : event.subject);
      const Slot slot = slotOf(before.mesh, patient);
      ASSERT_TRUE(slot.exists());
      EXPECT_TRUE(breaksBound(before.mesh, slot)) << "nothing was wrong with triangle " << patient;
      switch (event.kind) {
        case EventKind::vertex_refused:
          EXPECT_EQ(event.refusal, Refusal::bound_broken);
          EXPECT_EQ(support::trianglesOf(now.mesh), support::trianglesOf(before.mesh));
          break;
        case EventKind::vertex_moved:
          EXPECT_EQ(before.mesh.points[Vertex(event.vertex)], event.from);
          if (events.size() == 1) {
            EXPECT_EQ(now.mesh.points[Vertex(event.vertex)], event.at);
          }
          break;
        case EventKind::vertex_inserted:
        case EventKind::edge_split:
          EXPECT_GE(event.vertex, before.mesh.points.size());
          if (events.size() == 1) {
            EXPECT_EQ(now.mesh.points[Vertex(event.vertex)], event.at);
          }
          break;
        case EventKind::vertex_removed:
          EXPECT_EQ(now.mesh.kinds[Vertex(event.vertex)], VertexKind::removed);
          break;
        default:
          ADD_FAILURE() << "repair cannot say '" << name(event.kind) << "'";
      }
    }
    // Whatever it did, the mesh is better for it.
    if (events.front().kind == EventKind::vertex_refused) return;
    const Badness was = badnessOf(before.mesh, support::liveSlots(before.mesh));
    const Badness is = badnessOf(now.mesh, support::liveSlots(now.mesh));
    EXPECT_TRUE(is.broken < was.broken || (is.broken == was.broken && is.excess < was.excess));
  });
  EXPECT_GT(looked, 0) << "the domain no longer needs repair";
  support::expectValid(state.mesh);
}

}  // namespace
}  // namespace triscope::repair_test
