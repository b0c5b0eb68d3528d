// Each rule of section 3.1, worked out again from the state just before the decision, by other formulas.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "core/geometry/circumcircle.h"
#include "core/geometry/predicates.h"
#include "core/mesh/badness.h"
#include "core/mesh/edit.h"
#include "core/method/stages/insertion_rules.h"
#include "core/words/vocabulary.h"
#include "support/judge.h"
#include "support/meshes.h"
#include "support/runs.h"
#include "support/watch.h"

namespace triscope::steps_test {
namespace {

using support::operator""_v;

constexpr double kTolerance = 1e-9;

struct CornerPoints {
  Point a, b, c;
};

CornerPoints cornersOf(const Mesh& mesh, Slot slot) {
  const auto& v = triangleAt(mesh, slot).v;
  return {pointOf(mesh, v[0]), pointOf(mesh, v[1]), pointOf(mesh, v[2])};
}

double shortest(const CornerPoints& t) {
  return std::sqrt(std::min({squaredDistance(t.a, t.b), squaredDistance(t.b, t.c), squaredDistance(t.c, t.a)}));
}

// R = abc / (4 area).
double circumradius(const CornerPoints& t) {
  const double area = 0.5 * cross(t.b - t.a, t.c - t.a);
  return distance(t.a, t.b) * distance(t.b, t.c) * distance(t.c, t.a) / (4.0 * area);
}

struct Claim {
  Point at;
  double measured;
  double limit;
};

// What the paper asks of the triangle `slot` in this step; `other` is the adjacent triangle that the event names.
std::optional<Claim> claimOf(const MeshState& state, Stage step, Slot slot, Slot other) {
  const CornerPoints t = cornersOf(state.mesh, slot);
  const Point centre = circumcentre(t.a, t.b, t.c);
  const double radius = circumradius(t);
  const auto h = [&](Point p) { return edgeLengthAt(state.tree, p); };
  switch (step) {
    case Stage::step1:
      return Claim{centre, radius, h(centre)};
    case Stage::step2:
      return Claim{centre, radius, std::min({h(t.a), h(t.b), h(t.c)})};
    case Stage::step3:
      return Claim{centre, radius, shortest(t)};
    case Stage::step4:
      return Claim{centre, radius, shortest(cornersOf(state.mesh, other))};
    case Stage::step5:
      break;
    default:
      return std::nullopt;
  }
  for (int i = 0; i < 3; ++i) {
    const Half across = oppositeOf(state.mesh, halfOf(slot, i));
    if (!across.exists() || triangleOf(across) != other) continue;
    const Point p1 = pointOf(state.mesh, startOf(state.mesh, across));
    const Point p3 = pointOf(state.mesh, endOf(state.mesh, across));
    const Point p2 = pointOf(state.mesh, apexOf(state.mesh, across));
    const Point p4 = pointOf(state.mesh, apexOf(state.mesh, halfOf(slot, i)));
    const Point p5 = midpoint(p1, p3);
    const double height = cross(p3 - p1, p2 - p1) / distance(p1, p3);
    // The point lies over the shared edge as high as the smaller triangle, on the larger one's side.
    const Point toward = (1.0 / distance(p1, p3)) * perpendicular(p1 - p3);
    EXPECT_GT(dot(toward, p4 - p5), 0.0);
    return Claim{p5 + height * toward, distance(p5, p4), shortest({p1, p3, p2}) + height};
  }
  return std::nullopt;
}

std::vector<double> edgeAnglesSeen(const Mesh& mesh, Point p) {
  std::vector<double> cosines;
  for (const BoundaryEdge& edge : mesh.edges) {
    const Point u = pointOf(mesh, edge.v0) - p, v = pointOf(mesh, edge.v1) - p;
    cosines.push_back(dot(u, v) / (length(u) * length(v)));
  }
  return cosines;
}

bool inSomeTriangle(const Mesh& mesh, Point p) {
  return std::ranges::any_of(support::liveSlots(mesh), [&](Slot slot) {
    const CornerPoints t = cornersOf(mesh, slot);
    return orient2d(t.a, t.b, p) >= 0 && orient2d(t.b, t.c, p) >= 0 && orient2d(t.c, t.a, p) >= 0;
  });
}

void expectRefusalIsTrue(const MeshState& before, const Event& event) {
  switch (event.refusal) {
    case Refusal::outside_domain: {
      // Outside, or behind a boundary edge as the triangle sees it.
      const CornerPoints t = cornersOf(before.mesh, slotOf(before.mesh, TriangleId(event.subject)));
      const Point from = (1.0 / 3.0) * (t.a + t.b + t.c);
      const bool crosses = std::ranges::any_of(before.mesh.edges, [&](const BoundaryEdge& edge) {
        const Point a = pointOf(before.mesh, edge.v0), b = pointOf(before.mesh, edge.v1);
        return orient2d(from, event.at, a) != orient2d(from, event.at, b) &&
               orient2d(a, b, from) != orient2d(a, b, event.at);
      });
      EXPECT_TRUE(crosses || !inSomeTriangle(before.mesh, event.at));
      break;
    }
    case Refusal::encroaches_boundary: {
      const std::vector<double> cosines = edgeAnglesSeen(before.mesh, event.at);
      EXPECT_LT(std::ranges::min(cosines), -0.5 + kTolerance) << "no boundary edge is seen under more than 120 degrees";
      break;
    }
    case Refusal::too_close: {
      double nearest = INFINITY;
      for (const Vertex v : before.mesh.points.keys()) {
        if (before.mesh.vertexTriangle[v].exists())
          nearest = std::min(nearest, distance(before.mesh.points[v], event.at));
      }
      const CornerPoints small = cornersOf(before.mesh, slotOf(before.mesh, TriangleId(event.other)));
      EXPECT_LT(nearest, shortest(small));
      break;
    }
    default:
      ADD_FAILURE() << "refused as '" << name(event.refusal) << "', which these steps cannot say";
  }
}

void expectInserted(const MeshState& before, const MeshState& now, const Event& event) {
  ASSERT_EQ(event.vertex, before.mesh.points.size());
  ASSERT_EQ(now.mesh.points.size(), before.mesh.points.size() + 1);
  const Vertex vertex(event.vertex);
  EXPECT_EQ(pointOf(now.mesh, vertex), event.at);
  EXPECT_EQ(now.mesh.kinds[vertex], VertexKind::steiner);
  EXPECT_EQ(now.mesh.density[vertex], densityRankAt(now.tree, event.at));
  Star star;
  starOf(now.mesh, vertex, star);
  EXPECT_TRUE(star.closed);
  EXPECT_EQ(star.rim.size(), event.createdCount);
  for (const Half rim : star.rim) {
    const std::uint32_t id = idOf(now.mesh, triangleOf(rim)).word();
    EXPECT_GE(id, event.created);
    EXPECT_LT(id, event.created + event.createdCount);
  }
  EXPECT_EQ(event.createdCount, event.removedCount + 2u);
  // Theorems 1 and 2: a circumcentre is at least R from every vertex, a point of step 5 at least e.
  const double nearest = event.rule == Rule::step5
                             ? shortest(cornersOf(before.mesh, slotOf(before.mesh, TriangleId(event.other))))
                             : event.measured;
  for (const Half rim : star.rim) {
    EXPECT_GE(distance(event.at, pointOf(now.mesh, startOf(now.mesh, rim))), nearest * (1.0 - kTolerance));
  }
}

class Rules : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Domains, Rules, testing::Values(support::kNotched, support::kCrackedFrame, support::kRound),
                         [](const auto& json) {
                           return json.param == support::kNotched        ? "notched"
                                  : json.param == support::kCrackedFrame ? "cracked_frame"
                                                                         : "round";
                         });

TEST_P(Rules, EveryDecisionIsWhatItsEventSays) {
  Settings settings;
  settings.step4AreaRatio = 0.0;  // the paper's step 4, which has more to refuse
  MeshState state = support::start(support::domainFrom(GetParam()), settings);
  support::runPast(state, Stage::front2);
  ASSERT_EQ(state.stage, Stage::step1);
  std::map<Rule, int> inserted;
  int refused = 0;
  support::eachDecision(state, Stage::step5, [&](const MeshState& before, const MeshState& now, auto events) {
    if (events.empty() || events.front().stage > Stage::step5) return;  // repair speaks for itself
    ASSERT_EQ(events.size(), 1u);
    const Event& event = events.front();
    EXPECT_EQ(static_cast<int>(event.rule) - static_cast<int>(Rule::step1),
              static_cast<int>(event.stage) - static_cast<int>(Stage::step1));
    const Slot slot = slotOf(before.mesh, TriangleId(event.subject));
    ASSERT_TRUE(slot.exists()) << "the triangle " << event.subject << " is not there";
    const bool pair = event.rule == Rule::step4 || event.rule == Rule::step5;
    EXPECT_EQ(event.other != kNoId, pair);
    const Slot other = pair ? slotOf(before.mesh, TriangleId(event.other)) : Slot();
    if (pair) {
      ASSERT_TRUE(other.exists());
      EXPECT_TRUE(std::ranges::any_of(triangleAt(before.mesh, slot).adj,
                                      [&](Half half) { return half.exists() && triangleOf(half) == other; }));
    }
    const std::optional<Claim> claim = claimOf(before, event.stage, slot, other);
    ASSERT_TRUE(claim.has_value());
    EXPECT_NEAR(event.measured, claim->measured, kTolerance * claim->measured);
    EXPECT_NEAR(event.limit, claim->limit, kTolerance * claim->limit);
    EXPECT_GE(event.measured, event.limit * (1.0 - kTolerance)) << "the rule does not hold";
    EXPECT_LT(distance(event.at, claim->at), kTolerance * claim->measured);
    if (event.kind == EventKind::vertex_inserted) {
      EXPECT_EQ(event.refusal, Refusal::none);
      ++inserted[event.rule];
      expectInserted(before, now, event);
    } else {
      ASSERT_EQ(event.kind, EventKind::vertex_refused);
      ++refused;
      expectRefusalIsTrue(before, event);
      EXPECT_EQ(support::trianglesOf(now.mesh), support::trianglesOf(before.mesh));
      EXPECT_EQ(now.mesh.points, before.mesh.points);
      EXPECT_EQ(now.mesh.nextId, before.mesh.nextId);
    }
  });
  EXPECT_GT(inserted[Rule::step1], 0);
  if (GetParam() != support::kNotched) return;
  for (const Rule rule : {Rule::step2, Rule::step3, Rule::step4, Rule::step5}) {
    EXPECT_GT(inserted[rule], 0) << "the domain no longer shows " << name(rule);
  }
  EXPECT_GT(refused, 0);
}

Rule ruleOf(Stage step) {
  return static_cast<Rule>(static_cast<int>(Rule::step1) + static_cast<int>(step) - static_cast<int>(Stage::step1));
}

// Steps 1-3 look at one triangle at a time, so that nothing is left when the step is over; steps 4 and 5 look at pairs,
// and nothing is left when the rounds are over.
TEST_P(Rules, NothingIsLeftForAStepButWhatItRefused) {
  MeshState state = support::start(support::domainFrom(GetParam()));
  std::vector<Event> events;
  Journal journal{&events};
  const auto expectNothingLeft = [&](Stage step) {
    for (const Slot slot : support::liveSlots(state.mesh)) {
      Proposal proposal;
      LeafPath path;
      if (!proposes(step, state, slot, path, proposal)) continue;
      EXPECT_TRUE(std::ranges::any_of(events,
                                      [&](const Event& e) {
                                        return e.kind == EventKind::vertex_refused && e.rule == ruleOf(step) &&
                                               e.subject == idOf(state.mesh, slot).word();
                                      }))
          << name(ruleOf(step)) << " overlooked triangle " << idOf(state.mesh, slot);
    }
  };
  support::runPast(state, Stage::front2);
  for (const Stage step : {Stage::step1, Stage::step2, Stage::step3}) {
    ASSERT_EQ(state.stage, step);
    advance(state, Grain::stage, journal);
    expectNothingLeft(step);
  }
  while (state.stage < Stage::repair) advance(state, Grain::stage, journal);
  for (const Stage step : {Stage::step2, Stage::step3, Stage::step4, Stage::step5}) expectNothingLeft(step);
}

// The rules pass by what is clearly quiet without being asked: that must never hide a proposal, nor be of no use.
TEST_P(Rules, QuietIsWhatNoRuleProposesFor) {
  MeshState state = support::start(support::domainFrom(GetParam()));
  support::runPast(state, Stage::front2);
  std::size_t quiet = 0, asked = 0;
  support::eachDecision(state, Stage::repair, [&](const MeshState&, const MeshState& now, auto) {
    if (now.tick % 16 != 0) return;
    quiet = asked = 0;
    for (const Slot slot : support::liveSlots(now.mesh)) {
      const Quiet all = clearlyQuiet(now, slot);
      Proposal proposal;
      LeafPath path;
      for (const Stage step : {Stage::step2, Stage::step3, Stage::step4, Stage::step5})
        EXPECT_FALSE(all.of(step) && proposes(step, now, slot, path, proposal)) << slot;
      EXPECT_FALSE(all.bounds && breaksBound(now.mesh, slot)) << slot;
      ++asked;
      if (all.step3 && all.step4 && all.step5 && all.bounds) ++quiet;
    }
  });
  EXPECT_GT(asked, 0u);
  EXPECT_GT(quiet, asked * 9 / 10) << "by the end of the rounds";
}

TEST_P(Rules, TheLastRoundInsertsNothing) {
  MeshState state = support::start(support::domainFrom(GetParam()));
  std::vector<Event> events;
  Journal journal{&events};
  while (advanceUntil(state, Stage::step5, 1000, journal)) {
  }
  ASSERT_GT(events.size(), 0u);
  const std::uint16_t last =
      std::ranges::max(events, {}, [](const Event& e) { return e.stage <= Stage::repair ? e.round : 0; }).round;
  EXPECT_GE(last, 2) << "the first round inserts points, so another must follow";
  EXPECT_LT(last, state.settings.maxRounds) << "the rounds were cut off";
  for (const Event& event : events) {
    if (event.stage < Stage::step2 || event.round != last) continue;
    EXPECT_NE(event.kind, EventKind::vertex_inserted);
    EXPECT_NE(event.kind, EventKind::edge_split);
  }
}

// The first front builds an equilateral triangle on a kept edge of √3Δx or more. Its centre, which step 2 proposes,
// sees the edge under 120°: inserted, it left angles of exactly 30° and 120° that nothing could mend.
TEST(InsertionRules, NoPointSeesABoundaryEdgeUnder120Degrees) {
  support::expectBounds(support::after(support::domainFrom(R"({"min_edge_length": 1,
    "outer": [[-10, -10], [10, -10], [10, 10], [-10, 10]], "segments": [[[0, 0], [1.76, 0]]],
    "density": [{"at": [0.88, 1.2], "rank": 1}, {"at": [0.88, -1.2], "rank": 1},
      {"at": [0, 0], "rank": 1}, {"at": [1.76, 0], "rank": 1}]})"),
                                       Stage::step5));
}

TEST(InsertionRules, NearTiesAreInserted) {
  // An angle of 30° to the last bit gives R = e up to rounding: it must not be left behind on the wrong side.
  Mesh mesh = support::boxMesh({-4, -4}, {4, 4});
  const double half = 0.5;
  for (const Point p : {Point{0, 0}, Point{std::sqrt(3.0), 0}, Point{std::sqrt(3.0) * half, half}}) {
    support::insert(mesh, p);
  }
  MeshState state;
  state.mesh = mesh;
  const Half edge = findHalfEdge(mesh, 4_v, 5_v);
  ASSERT_TRUE(edge.exists());
  ASSERT_EQ(apexOf(mesh, edge), 6_v);
  Proposal proposal;
  LeafPath path;
  EXPECT_TRUE(proposes(Stage::step3, state, triangleOf(edge), path, proposal));
  EXPECT_NEAR(proposal.measured, proposal.limit, 1e-12);
}

}  // namespace
}  // namespace triscope::steps_test
