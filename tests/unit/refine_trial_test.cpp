// Step 6: the answer from one look at the star is that of the full trial, with the move made, measured and taken back.
#include "core/method/stages/refine_trial.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "core/geometry/predicates.h"
#include "core/mesh/edit.h"
#include "core/mesh/strain.h"
#include "core/method/stages/refine_marks.h"
#include "support/judge.h"
#include "support/meshes.h"
#include "support/random_domains.h"
#include "support/runs.h"

namespace triscope::refine_trial_test {
namespace {

using support::Random;

constexpr std::array kRules = {Rule::laplacian, Rule::reduce_obtuse, Rule::shared_edge, Rule::polish};

struct Tally {
  int quick = 0;
  int moved = 0;
  int refused = 0;
  int left = 0;  // to the full trial
};

std::vector<Vertex> movableOf(const Mesh& mesh) {
  std::vector<Vertex> movable;
  for (const Vertex v : mesh.points.keys())
    if (!mesh.vertexEdge[v].exists() && mesh.vertexTriangle[v].exists()) movable.push_back(v);
  return movable;
}

// Somewhere to go for the vertex, most often near, at times across its star, which is left in the room.
Move randomMove(const Mesh& mesh, Vertex vertex, Random& random, TrialRoom& room) {
  EXPECT_TRUE(gather(mesh, vertex, room.wheel));
  const Point from = pointOf(mesh, vertex);
  double nearest = 1e300;
  for (const Spoke& spoke : room.wheel.spokes) nearest = std::min(nearest, distance(from, spoke.at));
  const double step = nearest * (random.below(4) == 0 ? 1.0 : 0.2);
  const Point by{random.between(-step, step), random.between(-step, step)};
  return {kRules[random.below(kRules.size())], vertex, from + by};
}

// What the marks say is so.
void expectMarksHold(const Mesh& mesh) {
  for (const Slot slot : support::liveSlots(mesh)) {
    const std::uint8_t tested = mesh.tested[slot];
    const Triangle& t = triangleAt(mesh, slot);
    for (int i = 0; i < 3; ++i) {
      const Half across = t.adj[i];
      if ((tested & kEven) != 0 && across.exists()) {
        EXPECT_LE(twiceArea(mesh, triangleOf(across)), kLargeAreaRatio * twiceArea(mesh, slot));
      }
      if ((tested & kAcute) != 0) {
        EXPECT_GE(dotSign(pointOf(mesh, t.v[i]), pointOf(mesh, t.v[next3(i)]), pointOf(mesh, t.v[prev3(i)])), 0);
      }
    }
  }
}

// Both trials of one move, from the same state; goes on from what the full one left.
void expectAlike(MeshState& state, const Move& move, TrialRoom& room, Tally& tally) {
  MeshState quick = state;
  Verdict answer;
  const bool sure = tryInPlace(quick, move, room.wheel, answer);
  if (!sure || answer.refusal != Refusal::none) {
    ASSERT_EQ(support::difference(quick.mesh, state.mesh), "") << "changed without a move";
  }
  const Verdict expected = tryInFull(state, move, room);
  if (!sure) {
    ++tally.left;
    return;
  }
  ++tally.quick;
  ++(answer.refusal == Refusal::none ? tally.moved : tally.refused);
  ASSERT_EQ(answer.refusal, expected.refusal);
  ASSERT_EQ(answer.measured, expected.measured);
  ASSERT_EQ(answer.limit, expected.limit);
  if (answer.refusal != Refusal::none) return;
  expectMarksHold(quick.mesh);
  // The full trial remembers nothing around the move; the quick one what it knows to hold, and nothing of passes.
  for (const Slot slot : state.mesh.tested.keys()) {
    if (state.mesh.tested[slot] != quick.mesh.tested[slot]) {
      ASSERT_EQ(quick.mesh.tested[slot] & ~(kEven | kAcute), 0);
      ASSERT_EQ(state.mesh.tested[slot], 0);
    }
  }
  state.mesh.tested = quick.mesh.tested;
  ASSERT_EQ(support::difference(quick.mesh, state.mesh), "");
}

class QuickTrial : public testing::TestWithParam<int> {};

INSTANTIATE_TEST_SUITE_P(Shapes, QuickTrial, testing::Range(0, support::kShapes));

TEST_P(QuickTrial, AnswersAsTheFullOne) {
  Random random{static_cast<std::uint64_t>(601 + GetParam())};
  TrialRoom room;
  Tally tally;
  for (int k = 0; k < 6; ++k) {
    const support::SizeAndPlace placement = k == 0 ? support::SizeAndPlace{} : support::randomSizeAndPlace(random);
    const std::string text = support::randomDomain(random, static_cast<support::Shape>(GetParam()), placement);
    MeshState state = support::after(support::domainFrom(text), Stage::step5);
    state.cursor.of<Polishing>().worst = {.aspect = 4.0, .areaRatio = 2.8, .edgeRatio = 1.9, .radius = 0.95};
    for (std::uint8_t& tested : state.mesh.tested) tested = tested == kTestedAll ? kTestedAll : std::uint8_t{0};
    const std::vector<Vertex> movable = movableOf(state.mesh);
    for (int n = 0; n < 400 && !movable.empty(); ++n) {
      const Move move = randomMove(state.mesh, movable[random.below(movable.size())], random, room);
      expectAlike(state, move, room, tally);
      if (HasFatalFailure()) FAIL() << "domain " << k << ", move " << n << ": " << text;
    }
    support::expectValid(state.mesh);
  }
  EXPECT_GT(tally.moved, 100);
  EXPECT_GT(tally.refused, 100);
  EXPECT_GT(tally.left, 100);
}

}  // namespace
}  // namespace triscope::refine_trial_test
