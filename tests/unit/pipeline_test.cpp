// The stage table, the grains, and what every event of every stage promises whatever it is about.
#include "core/method/pipeline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/mesh/edit.h"
#include "core/mesh/validate.h"
#include "core/words/vocabulary.h"
#include "support/meshes.h"
#include "support/optimised.h"
#include "support/runs.h"
#include "support/watch.h"

namespace triscope::pipeline_test {
namespace {

TEST(StageTable, HasEveryStageInOrderWithItsOwnKey) {
  ASSERT_EQ(stages().size(), static_cast<std::size_t>(kStageCount));
  std::set<std::string_view> keys, names;
  for (std::size_t k = 0; k < stages().size(); ++k) {
    const StageInfo& info = stages()[k];
    EXPECT_EQ(info.id, static_cast<Stage>(k));
    EXPECT_EQ(&infoOf(info.id), &info);
    EXPECT_TRUE(keys.insert(info.key).second) << info.key;
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
    EXPECT_FALSE(info.does.empty());
    EXPECT_EQ(info.runOne == nullptr, info.id == Stage::finished);
  }
}

// Hashes in saved sessions hold them.
TEST(StageTable, CodesAreEachStagesOwn) {
  std::set<int> codes;
  for (const StageInfo& info : stages()) codes.insert(info.code);
  EXPECT_EQ(codes.size(), static_cast<std::size_t>(kStageCount));
  EXPECT_EQ(infoOf(Stage::refine).code, 15);
  EXPECT_EQ(infoOf(Stage::finished).code, 16);
}

TEST(Begin, TakesDxFromTheSettingsTheDomainOrTheGeometryInThatOrder) {
  const support::DomainPtr with = support::domainFrom(support::kFrame);
  EXPECT_EQ(support::start(with).minEdge, 1.0);
  EXPECT_FALSE(support::start(with).minEdgeDerived);
  Settings settings;
  settings.minEdge = 0.5;
  EXPECT_EQ(support::start(with, settings).minEdge, 0.5);
  const MeshState derived = support::start(support::domainFrom(R"({"outer": [[0, 0], [8, 0], [8, 8], [0, 8]]})"));
  EXPECT_TRUE(derived.minEdgeDerived);
  EXPECT_GT(derived.minEdge, 0.0);
}

TEST(Begin, NamesTheEdgeThatAsksForTooFineAMesh) {
  const auto state = begin(support::domainFrom(R"({"outer": [[0, 0], [1, 0], [1, 1e-12]]})"), {});
  ASSERT_FALSE(state.ok());
  EXPECT_EQ(state.error().loop, "outer");
  EXPECT_EQ(state.error().at, (Point{1, 0}));
  EXPECT_NE(state.error().message.find("the shortest edge of the domain is 1e-12 long"), std::string::npos);
}

// The Δx that is given would fit, but the density must follow the edge: its tree once had more ranks than bits.
TEST(Begin, NamesAnEdgeThatIsTooShortForTheGivenDx) {
  const auto state = begin(
      support::domainFrom(R"({"outer": [[0, 0], [1, 0], [1, 1], [1e-11, 1], [0, 1]], "min_edge_length": 0.1})"), {});
  ASSERT_FALSE(state.ok());
  EXPECT_EQ(state.error().at, (Point{1e-11, 1}));
  EXPECT_NE(state.error().message.find("the shortest edge of the domain is 1e-11 long"), std::string::npos);
}

TEST(Begin, RefusesADxThatFitsNoTree) {
  const support::DomainPtr domain = support::domainFrom(support::kFrame);
  for (const double minEdge : {17.0, 1e-9}) {
    Settings settings;
    settings.minEdge = minEdge;
    const Result<MeshState> state = begin(domain, settings);
    ASSERT_FALSE(state.ok()) << minEdge;
    EXPECT_NE(state.error().message.find("smallest edge"), std::string::npos);
    EXPECT_FALSE(state.error().hint.empty());
  }
}

TEST(Advance, ByOneDecisionMakesOneDecision) {
  MeshState state = support::start(support::domainFrom(support::kFrame));
  Journal nobody;
  while (state.stage != Stage::finished) {
    const std::uint64_t tick = state.tick;
    const bool more = advance(state, Grain::decision, nobody);
    ASSERT_TRUE(more);
    ASSERT_TRUE(state.tick == tick + 1 || state.stage == Stage::finished);
  }
  const std::uint64_t hash = hashOf(state);
  EXPECT_FALSE(advance(state, Grain::decision, nobody));
  EXPECT_FALSE(advance(state, Grain::all, nobody));
  EXPECT_EQ(hashOf(state), hash);
}

TEST(Advance, ByOneInsertionInsertsOnePoint) {
  MeshState state = support::start(support::domainFrom(support::kFrame));
  Journal nobody;
  std::size_t insertions = 0;
  for (;;) {
    const std::size_t before = state.mesh.points.size();
    advance(state, Grain::insertion, nobody);
    if (state.stage == Stage::finished) break;
    ++insertions;
    const std::size_t helpers = before == 0 ? 4 : 0;
    ASSERT_EQ(state.mesh.points.size(), before + helpers + 1);
  }
  EXPECT_GT(insertions, 50u);
}

TEST(Advance, ByOneStageVisitsThemInOrder) {
  MeshState state = support::start(support::domainFrom(support::kNotched));
  Journal nobody;
  std::vector<Stage> visited{state.stage};
  std::uint16_t round = 0;
  while (advance(state, Grain::stage, nobody)) {
    if (state.stage == visited.back()) continue;
    const bool again = state.stage == Stage::step2 && visited.back() != Stage::step1;
    if (again) {
      EXPECT_TRUE(visited.back() == Stage::step5 || visited.back() == Stage::repair);
      EXPECT_EQ(state.round, round + 1);
    } else {
      EXPECT_GT(state.stage, visited.back());
    }
    if (state.stage == Stage::step2) round = state.round;
    visited.push_back(state.stage);
  }
  for (const StageInfo& info : stages()) {
    const bool wanted = info.wanted == nullptr || info.wanted(state.settings);
    EXPECT_EQ(std::ranges::count(visited, info.id) > 0, wanted) << info.name;
  }
}

TEST(Advance, LeavesOutStep6WhenItIsSwitchedOff) {
  MeshState state = support::start(support::domainFrom(support::kFrame), support::withoutStep6());
  Journal nobody;
  while (advance(state, Grain::stage, nobody)) EXPECT_NE(state.stage, Stage::refine);
}

TEST(AdvanceUntil, StopsAfterTheStageOrTheLimit) {
  const support::DomainPtr domain = support::domainFrom(support::kFrame);
  Journal nobody;
  for (const StageInfo& info : stages()) {
    if (info.id == Stage::finished) continue;
    MeshState state = support::start(domain);
    while (advanceUntil(state, info.id, 100, nobody)) ASSERT_LE(state.stage, std::max(info.id, Stage::repair));
    EXPECT_GT(state.stage, info.id);
    if (info.id == Stage::step5) {
      EXPECT_EQ(state.stage, Stage::refine) << "rounds and repairs are over";
    }
  }
  MeshState state = support::start(domain);
  EXPECT_TRUE(advanceUntil(state, Stage::refine, 5, nobody));
  EXPECT_LE(state.tick, 5u);
}

TEST(Events, StagesBeginAndFinishInPairs) {
  MeshState state = support::start(support::domainFrom(support::kNotched));
  std::vector<Event> events;
  Journal journal{&events};
  while (advance(state, Grain::all, journal)) {
  }
  bool open = false;
  Stage stage = Stage::constraints;
  for (const Event& event : events) {
    if (event.kind == EventKind::stage_begun) {
      EXPECT_FALSE(open);
      open = true;
      stage = event.stage;
    } else {
      EXPECT_TRUE(open);
      EXPECT_EQ(event.stage, stage);
      if (event.kind == EventKind::stage_finished) open = false;
    }
  }
  EXPECT_FALSE(open);
}

std::set<std::uint32_t> liveIds(const Mesh& mesh) {
  std::set<std::uint32_t> ids;
  for (const Slot slot : support::liveSlots(mesh)) ids.insert(idOf(mesh, slot).word());
  return ids;
}

bool refusal(const Event& event) {
  if (event.kind == EventKind::edit_undone) return true;
  return event.kind == EventKind::vertex_refused || event.kind == EventKind::vertex_kept;
}

class EventsOf : public testing::TestWithParam<const char*> {
 protected:
  const std::vector<Settings> methods{Settings(), support::best(), support::optimised()};
};

INSTANTIATE_TEST_SUITE_P(Domains, EventsOf, testing::Values(support::kCrackedFrame, support::kRound));

// Every change of the mesh is announced: new triangles have the ids that the events say, new vertices are named, and a
// refusal changes nothing and says why.
TEST_P(EventsOf, AccountForEveryChange) {
  for (const Settings& settings : methods) {
    MeshState state = support::start(support::domainFrom(GetParam()), settings);
    std::set<std::uint32_t> before;
    std::uint64_t decisions = 0;
    support::eachDecision(state, Stage::optimise, [&](const MeshState& was, const MeshState& is, auto events) {
      ++decisions;
      ASSERT_GE(events.size(), 1u) << "decision " << decisions << " in " << infoOf(was.stage).name << " said nothing";
      ASSERT_TRUE(events.size() <= 2 || optimisesMesh(was.stage));
      const bool changed = was.mesh.nextId != is.mesh.nextId || was.mesh.points.size() != is.mesh.points.size();
      std::set<std::uint32_t> announced;
      for (const Event& event : events) {
        EXPECT_EQ(event.stage, events.front().stage);
        EXPECT_EQ(refusal(event), event.refusal != Refusal::none) << name(event.kind);
        EXPECT_NE(event.rule, Rule::none) << name(event.kind);
        EXPECT_NE(event.kind, EventKind::failure);
        if (refusal(event)) {
          EXPECT_FALSE(changed);
          EXPECT_EQ(event.createdCount, 0u);
        }
        if (event.kind == EventKind::cell_split) continue;
        for (std::uint32_t k = 0; k < event.createdCount; ++k) announced.insert(event.created + k);
        if (event.createdCount > 0) {
          EXPECT_GE(event.created, was.mesh.nextId.word());
          EXPECT_LE(event.created + event.createdCount, is.mesh.nextId.word());
        }
        if (event.kind == EventKind::vertex_inserted || event.kind == EventKind::edge_split) {
          ASSERT_LT(event.vertex, is.mesh.points.size());
          EXPECT_GE(event.vertex, was.mesh.points.size());
          EXPECT_EQ(is.mesh.points[Vertex(event.vertex)], event.at);
        }
      }
      if (!changed && events.front().kind != EventKind::triangle_removed) return;
      const std::set<std::uint32_t> after = liveIds(is.mesh);
      if (before.empty()) before = liveIds(was.mesh);
      std::size_t gone = 0, fresh = 0;
      for (const std::uint32_t id : after) {
        if (before.count(id) != 0) continue;
        ++fresh;
        // The two triangles of the box around everything come with the first point.
        EXPECT_TRUE(announced.count(id) != 0 || was.mesh.points.empty()) << "nobody announced triangle " << id;
      }
      for (const std::uint32_t id : before) gone += after.count(id) == 0 ? 1u : 0u;
      if (events.size() == 1 && events.front().removedCount > 0 && !was.mesh.points.empty()) {
        EXPECT_EQ(events.front().removedCount, gone) << name(events.front().kind);
        EXPECT_EQ(events.front().createdCount, fresh) << name(events.front().kind);
      }
      before = after;
    });
    EXPECT_GT(decisions, 500u);
    EXPECT_EQ(state.stage, Stage::finished);
  }
}

TEST_P(EventsOf, AgreeWithTheCounts) {
  for (const Settings& settings : methods) {
    MeshState state = support::start(support::domainFrom(GetParam()), settings);
    std::vector<Event> events;
    Journal journal{&events};
    while (advance(state, Grain::all, journal)) {
    }
    for (const StageInfo& info : stages()) {
      StageCounts counted;
      for (const Event& event : events) {
        if (event.stage != info.id) continue;
        counted.inserted += event.kind == EventKind::vertex_inserted || event.kind == EventKind::edge_split ? 1 : 0;
        counted.refused += refusal(event) ? 1u : 0u;
        counted.moved += event.kind == EventKind::vertex_moved ? 1 : 0;
        counted.removed += event.kind == EventKind::vertex_removed ? 1 : 0;
      }
      const StageCounts& counts = state.counts[info.id];
      EXPECT_EQ(counts.refused, counted.refused) << info.name;
      EXPECT_EQ(counts.moved, counted.moved) << info.name;
      EXPECT_EQ(counts.removed, counted.removed) << info.name;
      EXPECT_EQ(counts.inserted, counted.inserted) << info.name;
    }
  }
}

TEST_P(EventsOf, LeaveAValidMeshAfterEveryStage) {
  MeshState state = support::start(support::domainFrom(GetParam()));
  Journal nobody;
  while (advance(state, Grain::stage, nobody)) {
    // Before carve the boundary edges are listed, but not yet marked in the triangles.
    for (const Violation& violation : validate(state.mesh)) {
      if (state.stage <= Stage::carve && violation.what == Broken::boundary) continue;
      ADD_FAILURE() << "before " << infoOf(state.stage).name << ": " << violation.message;
    }
  }
}

}  // namespace
}  // namespace triscope::pipeline_test
