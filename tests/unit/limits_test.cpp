// Every stage comes to an end, also where its rule alone would go on: each limit is spent once.
#include "core/method/stages/limits.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>

#include "core/geometry/trig.h"
#include "support/judge.h"
#include "support/meshes.h"
#include "support/random.h"
#include "support/runs.h"

namespace triscope::limits_test {
namespace {

using support::Random;

// A square with chains that leave one point in many directions, some of them drawn toward it.
std::string hub(Random& random, std::size_t chains, bool even) {
  std::string text;
  for (std::size_t k = 0; k < chains; ++k) {
    const double turn = (static_cast<double>(k) + (even ? 0.0 : random.between(-0.45, 0.45)));
    const trig::SinCos way = trig::sinCos(2.0 * trig::kPi * turn / static_cast<double>(chains));
    const double reach = random.between(0.2, 0.9);
    const std::string tip = fmt::format("[{:.6f}, {:.6f}]", reach * way.cos, reach * way.sin);
    text += text.empty() ? "" : ", ";
    text += k % 2 == 0 ? "[[0, 0], " + tip + "]" : "[" + tip + ", [0, 0]]";
  }
  return R"({"outer": [[-1, -1], [1, -1], [1, 1], [-1, 1]], "segments": [)" + text + "]}";
}

// Split half-way, edges at a common point call for one another's splits down to lengths whose determinants are no
// longer doubles.
TEST(Limits, HubsAreMeshedAtOnce) {
  Random random{81};
  for (std::size_t chains = 3; chains <= 36; chains += 3) {
    for (const bool even : {true, false}) {
      const std::string text = hub(random, chains, even);
      SCOPED_TRACE(text);
      const support::DomainPtr domain = support::domainFrom(text);
      const MeshState state = support::after(domain, Stage::step5);
      ASSERT_FALSE(state.failed);
      support::expectValid(state.mesh);
      support::expectFollowsDomain(state);
      const auto count = [&](Stage stage) { return state.counts[stage]; };
      EXPECT_LT(count(Stage::recovery).inserted, mostSplits(state) / 4);
      EXPECT_LT(state.mesh.points.size(), mostVertices(state) / 4);
      EXPECT_LT(count(Stage::repair).decisions, mostRepairs(state));
    }
  }
}

MeshState before(const char* json, Stage stage, std::vector<Event>* events) {
  MeshState state = support::start(support::domainFrom(json));
  Journal journal{events};
  while (state.stage < stage) advance(state, Grain::stage, journal);
  if (events != nullptr) events->clear();
  return state;
}

// Two holes whose tips come as near as is said to a chain, from both sides. Nobody looks for the gaps.
MeshState betweenTips(double gap) {
  Settings settings;
  settings.gapFraction = 10.0;
  return support::start(support::domainFrom(fmt::format(R"({{"min_edge_length": 0.5,
    "outer": [[-10, -10], [10, -10], [10, 10], [-10, 10]], "segments": [[[0, 0], [9, 0]]],
    "holes": [[[5.1, {0}], [6, 3], [4, 3]], [[5.1, -{0}], [4, -3], [6, -3]]]}})",
                                                        gap)),
                        settings);
}

Event failureIn(const std::vector<Event>& events) {
  const auto failure = std::ranges::find(events, EventKind::failure, &Event::kind);
  if (failure == events.end()) {
    ADD_FAILURE() << "it did not give up";
    return {};
  }
  EXPECT_EQ(failure->stage, Stage::recovery);
  EXPECT_EQ(failure->rule, Rule::recover_edge);
  return *failure;
}

TEST(Limits, RecoveryGivesUpBelowTheShortestEdge) {
  std::vector<Event> events;
  Journal journal{&events};
  MeshState state = betweenTips(1e-9);
  advance(state, Grain::all, journal);
  EXPECT_TRUE(state.failed);
  const Event event = failureIn(events);
  EXPECT_EQ(event.refusal, Refusal::too_close);
  EXPECT_EQ(event.limit, shortestMade(state));
  EXPECT_LT(event.measured, event.limit);
  EXPECT_NEAR(event.at.x, 5.1, 1e-6) << "the place is between the tips";
}

TEST(Limits, RecoveryGivesUpWhenItsSplitsAreSpent) {
  std::vector<Event> events;
  Journal journal{&events};
  MeshState state = betweenTips(1e-4);
  while (state.stage < Stage::recovery) advance(state, Grain::stage, journal);
  MeshState spent = state;
  support::runPast(state, Stage::carve);
  EXPECT_FALSE(state.failed);
  advance(spent, Grain::insertion, journal);
  ASSERT_EQ(spent.stage, Stage::recovery);
  spent.cursor.changes = mostSplits(spent);
  advance(spent, Grain::stage, journal);
  EXPECT_TRUE(spent.failed);
  const Event event = failureIn(events);
  EXPECT_EQ(event.refusal, Refusal::budget_spent);
  EXPECT_EQ(event.limit, static_cast<double>(mostSplits(spent)));
}

// Foreseeing nothing, steps 1-5 may put in a thousand points only.
TEST(Limits, StepsLeaveTheRestUndone) {
  std::vector<Event> events;
  MeshState state = before(R"({"outer": [[0, 0], [10, 0], [10, 10], [0, 10]], "min_edge_length": 0.1,
    "density": [{"box": [[0, 0], [10, 10]], "length": 0.1}]})",
                           Stage::step1, &events);
  state.estimatedTriangles = 0.0;
  const std::size_t most = mostVertices(state);
  Journal journal{&events};
  advance(state, Grain::stage, journal);
  EXPECT_EQ(state.stage, Stage::step2);
  EXPECT_EQ(state.mesh.points.size(), most);
  const auto spent = std::ranges::find(events, Refusal::budget_spent, &Event::refusal);
  ASSERT_NE(spent, events.end());
  EXPECT_EQ(spent->kind, EventKind::vertex_refused);
  EXPECT_EQ(spent->stage, Stage::step1);
  support::expectValid(state.mesh);
}

TEST(Limits, RepairLeavesTheRestAsItIs) {
  std::vector<Event> events;
  MeshState state = before(support::kNotched, Stage::repair, &events);
  StageCounts& counts = state.counts[Stage::repair];
  counts.decisions = mostRepairs(state);
  const auto triangles = support::trianglesOf(state.mesh);
  Journal journal{&events};
  advance(state, Grain::stage, journal);
  EXPECT_NE(state.stage, Stage::repair);
  EXPECT_EQ(std::ranges::count(events, Refusal::budget_spent, &Event::refusal), 1);
  EXPECT_EQ(support::trianglesOf(state.mesh), triangles);
}

}  // namespace
}  // namespace triscope::limits_test
