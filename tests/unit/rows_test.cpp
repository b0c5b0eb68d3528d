#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>

#include "core/geometry/circumcircle.h"
#include "core/mesh/edit.h"
#include "core/method/method.h"
#include "core/method/stages/row_placement.h"
#include "core/words/vocabulary.h"
#include "support/domains.h"
#include "support/judge.h"
#include "support/optimised.h"
#include "support/runs.h"
#include "support/watch.h"

namespace triscope::rows_test {
namespace {

constexpr std::array kRowPlacements{Placement::rebay, Placement::size_optimal, Placement::tiling, Placement::spokes};

std::string textOf(Placement placement) {
  Settings settings;
  settings.placement = placement;
  return valueText(*findSetting("placement"), settingValue(settings, *findSetting("placement")));
}

TEST(Rows, FillEveryDomainToTheSizeThatIsWanted) {
  for (const char* const text : {support::kFrame, support::kCrackedFrame, support::kRound, support::kNotched}) {
    for (const Placement placement : kRowPlacements) {
      const MeshState state = support::after(support::domainFrom(text), Stage::rows, support::rowsOf(placement));
      SCOPED_TRACE(textOf(placement) + " of " + std::string(text));
      ASSERT_FALSE(state.failed);
      support::expectValid(state.mesh);
      support::expectFollowsDomain(state, 1e-9);
      ASSERT_EQ(state.sizes.size(), state.mesh.points.size());
      int large = 0;
      for (const Slot slot : state.mesh.triangles.keys())
        if (state.mesh.alive(slot) && !isSmall(state, slot, 1.4)) ++large;
      EXPECT_LE(large, 2 + static_cast<int>(state.mesh.liveCount()) / 20) << "but where the boundary is in the way";
    }
  }
}

TEST(Rows, TakeThePlaceOfTheFrontsAndOfStepOne) {
  const MeshState rows = support::finished(support::domainFrom(support::kRound), support::rowsOf(Placement::spokes));
  EXPECT_GT(rows.counts[Stage::rows].inserted, 0u);
  for (const Stage stage : {Stage::front1, Stage::front2, Stage::step1}) EXPECT_EQ(rows.counts[stage].decisions, 0u);
  support::expectBounds(rows);  // the rounds have seen to them
  const MeshState steps = support::finished(support::domainFrom(support::kRound));
  EXPECT_EQ(steps.counts[Stage::rows].decisions, 0u);
  EXPECT_GT(steps.counts[Stage::step1].inserted, 0u);
}

TEST(Rows, PutNoPointNearerToAnotherThanSevenTenthsOfTheLengthWanted) {
  for (const Placement placement : kRowPlacements) {
    MeshState state = support::after(support::domainFrom(support::kRound), Stage::carve, support::rowsOf(placement));
    support::eachDecision(state, Stage::rows, [&](const MeshState& before, const MeshState& now, auto events) {
      ASSERT_EQ(events.size(), 1u);
      const Event& event = events.front();
      if (event.stage != Stage::rows || event.kind != EventKind::vertex_inserted) return;
      const Vertex vertex(event.vertex);
      for (const Vertex other : before.mesh.points.keys()) {
        if (!before.mesh.vertexTriangle[other].exists()) continue;
        ASSERT_GE(distance(pointOf(before.mesh, other), event.at), 0.7 * now.sizes[vertex] * (1 - 1e-12));
      }
      ASSERT_EQ(event.limit, now.sizes[vertex]);
    });
  }
}

TEST(Rows, SayWhatTheyRefuseAndWhy) {
  std::size_t refused = 0;
  for (const Placement placement : kRowPlacements) {
    MeshState state = support::after(support::domainFrom(support::kNotched), Stage::carve, support::rowsOf(placement));
    support::eachDecision(state, Stage::rows, [&](const MeshState& before, const MeshState& now, auto events) {
      const Event& event = events.front();
      if (event.stage != Stage::rows) return;
      EXPECT_EQ(event.rule == Rule::row_rest || event.rule == Rule::tiling ||
                    event.rule == (placement == Placement::rebay          ? Rule::rebay
                                   : placement == Placement::size_optimal ? Rule::size_optimal
                                                                          : Rule::spokes),
                true);
      if (event.kind != EventKind::vertex_refused) return;
      ++refused;
      EXPECT_NE(event.refusal, Refusal::none);
      EXPECT_EQ(before.mesh.nextId, now.mesh.nextId) << "what is refused changes nothing";
    });
  }
  EXPECT_GT(refused, 0u);
}

TEST(Rows, OfSpokesAreNearlyRegularAlongAStraightBoundary) {
  Settings even = support::rowsOf(Placement::spokes);
  even.maxRank = 1;
  const MeshState state =
      support::after(support::domainFrom(R"({"outer": [[0, 0], [20, 0], [20, 10], [0, 10]], "min_edge_length": 1})"),
                     Stage::rows, even);
  int regular = 0, inner = 0;
  Star star;
  for (const Vertex v : state.mesh.points.keys()) {
    if (!state.mesh.vertexTriangle[v].exists() || state.mesh.vertexEdge[v].exists()) continue;
    starOf(state.mesh, v, star);
    ++inner;
    regular += star.rim.size() == 6 ? 1 : 0;
  }
  EXPECT_GT(regular, inner * 8 / 10) << regular << " of " << inner;
}

TEST(OffCentre, LiesNearerToTheShortestEdgeThanTheCircumcentre) {
  Settings off = support::withoutStep6();
  off.placement = Placement::off_centre;
  MeshState state = support::after(support::domainFrom(support::kRound), Stage::front2, off);
  int nearer = 0;
  support::eachDecision(state, Stage::step5, [&](const MeshState& before, const MeshState&, auto events) {
    const Event& event = events.front();
    if (event.rule < Rule::step1 || event.rule > Rule::step4) return;
    const Slot slot = slotOf(before.mesh, TriangleId(event.subject));
    const Triangle& t = triangleAt(before.mesh, slot);
    const Circumcircle circle =
        circumcircle(pointOf(before.mesh, t.v[0]), pointOf(before.mesh, t.v[1]), pointOf(before.mesh, t.v[2]));
    ASSERT_LT(squaredDistance(event.at, circle.centre), circle.squaredRadius);
    nearer += event.at == circle.centre ? 0 : 1;
  });
  EXPECT_GT(nearer, 0);
  support::expectBounds(state);
}

TEST(BoundaryPoints, AreCountedByRatioWhereLengthsAreContinuous) {
  // Sides of every length between one edge and three: each is within √2 of what is wanted.
  for (double side = 1.03; side < 3.0; side += 0.07) {
    const std::string text =
        fmt::format(R"({{"outer": [[0, 0], [{0}, 0], [{0}, {0}], [0, {0}]], "min_edge_length": 1}})", side);
    Settings settings;
    settings.size = SizeField::continuous;
    const MeshState state = support::after(support::domainFrom(text), Stage::boundary, settings);
    for (std::size_t k = 0; k + 1 < state.boundary.size(); ++k) {
      if (state.boundary[k].curve != state.boundary[k + 1].curve) continue;
      const double edge = distance(state.boundary[k].at, state.boundary[k + 1].at);
      const double part = edge / edgeLengthAt(state.tree, midpoint(state.boundary[k].at, state.boundary[k + 1].at));
      EXPECT_GT(part, 0.7) << side;
      EXPECT_LT(part, 1.42) << side;
    }
  }
}

}  // namespace
}  // namespace triscope::rows_test
