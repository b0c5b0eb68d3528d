#include <gtest/gtest.h>

#include <map>

#include "core/geometry/predicates.h"
#include "core/mesh/edit.h"
#include "core/mesh/slide.h"
#include "core/mesh/validate.h"
#include "core/method/method.h"
#include "core/optimise/glide.h"
#include "core/optimise/penalty.h"
#include "core/quality/quality.h"
#include "core/words/vocabulary.h"
#include "support/domains.h"
#include "support/judge.h"
#include "support/meshes.h"
#include "support/optimised.h"
#include "support/random.h"
#include "support/runs.h"
#include "support/watch.h"

namespace triscope::optimise_test {
namespace {

using support::Random;

constexpr std::array kSamples{"blunt_body", "cylinder", "l_shape", "letter",  "naca0012",
                              "narrow_gap", "square",   "step",    "annulus", "cracked_plate"};

support::DomainPtr sample(const char* name) {
  return support::domainAt(support::samples() / (std::string(name) + ".json"));
}

TEST(Optimise, LeavesNoObtuseTriangleAndNothingBeyondTheEasyMark) {
  for (const char* const name : kSamples) {
    for (const bool rows : {true, false}) {
      SCOPED_TRACE(std::string(name) + (rows ? ", from rows" : ", from step 6"));
      const MeshState state = support::finished(sample(name), rows ? support::best() : support::optimised());
      ASSERT_FALSE(state.failed);
      support::expectValid(state.mesh);
      support::expectFollowsDomain(state, 1e-9);
      support::expectBounds(state);
      const Quality quality = measure(state.mesh);
      EXPECT_EQ(quality.obtuse, 0u);
      EXPECT_GT(quality.minAngle, rows ? 42.5 : 41.5);
      EXPECT_LT(quality.maxAngle, rows ? 86.5 : 88.0);
      EXPECT_LT(quality.areaRatioMax, 1.6);
      EXPECT_LT(quality.edgeRatioMax, 1.48);
    }
  }
}

TEST(Optimise, GoesFurtherWhereTheDialAsksForIt) {
  double lowest = 0.0, highest = 180.0;
  for (const Dial dial : {Dial::easy, Dial::standard, Dial::acute}) {
    const Quality quality = measure(support::finished(sample("naca0012"), support::best(dial)).mesh);
    EXPECT_GT(quality.minAngle, lowest);
    EXPECT_LT(quality.maxAngle, highest);
    lowest = quality.minAngle + 0.05;
    highest = quality.maxAngle - 2.0;
  }
  EXPECT_GT(lowest, 44.0);
  EXPECT_LT(highest, 75.0);
}

TEST(Optimise, KeepsToAnglesThatAreGiven) {
  Settings settings = support::best();
  settings.lowestAngle = 40.0;
  settings.highestAngle = 89.0;
  settings.areaRatio = 1.8;
  settings.edgeRatio = 1.6;
  const Quality quality = measure(support::finished(sample("blunt_body"), settings).mesh);
  EXPECT_GT(quality.minAngle, 39.7);
  EXPECT_LT(quality.maxAngle, 89.3);
}

TEST(Optimise, EndsWhateverIsAskedForAndLeavesAValidMesh) {
  for (const auto& [low, high] : {std::pair{55.0, 62.0}, std::pair{1.0, 61.0}, std::pair{59.9, 120.0}}) {
    Settings settings = support::best();
    settings.lowestAngle = std::min(low, 55.0);
    settings.highestAngle = high;
    settings.areaRatio = 1.01;
    settings.edgeRatio = 1.01;
    const MeshState state = support::finished(sample("square"), settings);
    support::expectValid(state.mesh);
    EXPECT_EQ(state.stage, Stage::finished);
  }
}

/// Everything that must hold after each decision on the way: a triangulation with the domain's boundary, every triangle
/// counter-clockwise. Whether it is Delaunay is seen to between passes.
void expectTriangulation(const MeshState& state) {
  for (const Violation& violation : validate(state.mesh, 100))
    if (violation.what != Broken::delaunay) ADD_FAILURE() << violation.message << " at tick " << state.tick;
  ASSERT_FALSE(testing::Test::HasFailure());
}

TEST(Optimise, KeepsATriangulationOfTheDomainAfterEveryDecision) {
  for (const char* const text : {support::kFrame, support::kCrackedFrame, support::kRound}) {
    Settings settings = support::optimised(Dial::acute);
    MeshState state = support::after(support::domainFrom(text), Stage::refine, settings);
    const long double area = support::areaOf(state);
    std::size_t decisions = 0;
    support::eachDecision(state, Stage::optimise, [&](const MeshState&, const MeshState& now, auto) {
      ++decisions;
      expectTriangulation(now);
    });
    EXPECT_GT(decisions, 100u);
    if (text != support::kRound) {
      EXPECT_NEAR(double(support::areaOf(state) / area), 1.0, 1e-12);
    }
    support::expectValid(state.mesh);
    support::expectFollowsDomain(state, 1e-9);
  }
}

TEST(Optimise, EventsSayWhereEveryVertexIs) {
  for (const char* const text : {support::kNotched, support::kRound, support::kCrackedFrame}) {
    for (const Settings& settings : {support::best(Dial::acute), support::optimised(Dial::acute)}) {
      MeshState state = support::start(support::domainFrom(text), settings);
      std::vector<Event> events;
      Journal journal{&events};
      while (advance(state, Grain::all, journal)) {
      }
      std::map<std::uint32_t, Point> places;
      std::uint32_t nextId = 0;
      bool first = true;
      for (const Event& event : events) {
        if (event.createdCount > 0 && wordsOf(event.kind).created == Names::triangle) {
          if (!first) {
            ASSERT_EQ(event.created, nextId) << "ids are given out in order";
          }
          first = false;
          nextId = event.created + event.createdCount;
        }
        if (event.kind == EventKind::vertex_removed) places.erase(event.vertex);
        if (!placesVertex(event)) continue;
        if (event.kind == EventKind::vertex_moved && event.stage == Stage::optimise) {
          ASSERT_TRUE(places.contains(event.vertex));
          ASSERT_EQ(places[event.vertex], event.from) << "vertex " << event.vertex;
        }
        places[event.vertex] = event.at;
      }
      EXPECT_EQ(nextId, state.mesh.nextId.n);
      for (const Vertex v : state.mesh.points.keys()) {
        if (!state.mesh.vertexTriangle[v].exists()) continue;
        ASSERT_TRUE(places.contains(v.word())) << "vertex " << v.n << " was never placed";
        ASSERT_EQ(places[v.word()], pointOf(state.mesh, v)) << "vertex " << v.n;
      }
    }
  }
}

TEST(Optimise, KeepsBoundaryVerticesOnTheirCurves) {
  const support::DomainPtr domain = support::domainFrom(support::kRound);
  const MeshState state = support::finished(domain, support::best(Dial::acute));
  int slid = 0;
  for (const Vertex v : state.mesh.points.keys()) {
    if (!state.mesh.vertexTriangle[v].exists()) continue;
    if (const std::optional<OnCurve> place = onCurve(state.mesh, v)) {
      EXPECT_EQ(pointOf(state.mesh, v), pointAt(domain->curves[place->curve], place->t));
      ++slid;
    }
  }
  EXPECT_GT(slid, 50);
}

TEST(Optimise, GivesTheSameMeshStepByStepFromCopiesAndUnheard) {
  for (const bool rows : {true, false}) {
    const Settings settings = rows ? support::best(Dial::acute) : support::optimised(Dial::acute);
    const support::DomainPtr domain = support::domainFrom(rows ? support::kNotched : support::kFrame);
    const MeshState whole = support::finished(domain, settings);
    MeshState state = support::start(domain, settings);
    std::vector<Event> events;
    Journal journal{&events};
    Random random{11};
    std::vector<std::uint64_t> copiedAt;
    for (int k = 0; k < 100; ++k) copiedAt.push_back(random.below(whole.tick));
    std::ranges::sort(copiedAt);
    std::vector<MeshState> copies;
    for (auto next = copiedAt.begin(); advance(state, Grain::decision, journal);) {
      while (next != copiedAt.end() && *next <= state.tick) {
        if (copies.empty() || copies.back().tick != state.tick) copies.push_back(state);
        ++next;
      }
    }
    EXPECT_EQ(hashOf(state), hashOf(whole));
    EXPECT_EQ(state.tick, whole.tick);
    Journal nobody;
    for (MeshState& copy : copies) {
      while (advance(copy, Grain::all, nobody)) {
      }
      ASSERT_EQ(hashOf(copy), hashOf(whole));
    }
    EXPECT_GT(copies.size(), 50u);
  }
}

TEST(Optimise, ChangesNothingByWhatItTakesBack) {
  MeshState state =
      support::after(support::domainFrom(support::kNotched), Stage::refine, support::optimised(Dial::acute));
  std::size_t undone = 0, kept = 0;
  support::eachDecision(state, Stage::optimise, [&](const MeshState& before, const MeshState& now, auto events) {
    ASSERT_FALSE(events.empty());
    const Event& last = events.back();
    if (last.kind == EventKind::edit_kept) ++kept;
    if (last.kind != EventKind::edit_undone) return;
    ++undone;
    ASSERT_EQ(events.size(), 1u);
    ASSERT_EQ(before.mesh.nextId, now.mesh.nextId);
    ASSERT_EQ(before.mesh.points, now.mesh.points);
    ASSERT_EQ(before.mesh.freeSlots, now.mesh.freeSlots);
    ASSERT_EQ(before.sizes, now.sizes);
  });
  EXPECT_GT(undone, 0u);
  EXPECT_GT(kept, 0u);
}

TEST(Optimise, AnnealingLowersTheSumOfSquaredExcess) {
  MeshState state = support::after(sample("naca0012"), Stage::refine, support::optimised());
  const auto sum = [](const Excess& excess) {
    long total = 0;
    for (const std::int8_t e : excess) total += long{e} * e;
    return total;
  };
  int glides = 0;
  long before = sum(excessOf(state.mesh));
  const long start = before;
  support::eachDecision(state, Stage::optimise, [&](const MeshState&, const MeshState& now, auto events) {
    if (events.back().rule != Rule::anneal) {
      before = -1;
      return;
    }
    const long after = sum(excessOf(now.mesh));
    ASSERT_EQ(std::get<Optimising>(now.cursor.ahead).excess, excessOf(now.mesh)) << "it is kept up to date by flips";
    if (before >= 0 && events.back().kind == EventKind::edit_kept) {
      ASSERT_LT(after, before);
      EXPECT_EQ(events.back().limit - events.back().measured, double(before - after));
    }
    before = after;
    ++glides;
  });
  EXPECT_GT(glides, 20);
  EXPECT_LT(sum(excessOf(state.mesh)), start);
}

TEST(Excess, CountsTrianglesBeyondWhatSuitsAVertex) {
  // A square in two triangles: of a right angle two suit.
  const Mesh mesh = support::meshOf({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 1, 2}, {0, 2, 3}});
  EXPECT_EQ(excessOf(mesh, Vertex(0)), 0);
  EXPECT_EQ(excessOf(mesh, Vertex(1)), -1);
}

TEST(Optimise, LeavesWhatTouchesASharpCornerAndMendsTheRest) {
  // Chains that leave one point at eighteen degrees: what lies between them must be sharp.
  const MeshState state = support::finished(
      support::domainFrom(R"({"outer": [[-10, -10], [10, -10], [10, 10], [-10, 10]], "min_edge_length": 0.5,
                              "segments": [[[0, 0], [6, 0]], [[0, 0], [6, 2]]]})"),
      support::best());
  support::expectValid(state.mesh);
  const Mesh& mesh = state.mesh;
  for (const Slot slot : mesh.triangles.keys()) {
    if (!mesh.alive(slot)) continue;
    const Triangle& t = triangleAt(mesh, slot);
    for (int i = 0; i < 3; ++i) {
      if (dotSign(pointOf(mesh, t.v[i]), pointOf(mesh, t.v[next3(i)]), pointOf(mesh, t.v[prev3(i)])) >= 0) continue;
      EXPECT_TRUE(std::ranges::any_of(t.v, [&](Vertex v) { return length(pointOf(mesh, v)) < 2.5; }))
          << "obtuse away from the corner at " << pointOf(mesh, t.v[0]).x << ", " << pointOf(mesh, t.v[0]).y;
    }
  }
}

}  // namespace
}  // namespace triscope::optimise_test
