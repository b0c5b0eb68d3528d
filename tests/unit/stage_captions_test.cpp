// Every number that is said of a stage at its end is held against the state, counted another way.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstring>
#include <functional>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "core/base/counted.h"
#include "core/explain/caption.h"
#include "core/method/estimate.h"
#include "support/optimised.h"
#include "support/runs.h"

namespace triscope::stage_captions_test {
namespace {

constexpr std::array kSamples{"blunt_body.json", "cracked_plate.json", "cylinder.json",
                              "letter.json",     "naca0012.json",      "narrow_gap.json"};

/// "12 345" reads as one number; digits that belong to a name ("step 3") are left out.
std::vector<double> numbersIn(std::string text, const std::string& name) {
  text = ungrouped(std::move(text));
  text = text.substr(text.find(name.substr(1)) + name.size() - 1);
  std::vector<double> numbers;
  for (std::size_t k = 0; k < text.size();) {
    if (std::isdigit(static_cast<unsigned char>(text[k])) == 0) {
      ++k;
      continue;
    }
    std::size_t length = 0;
    numbers.push_back(std::stod(text.substr(k), &length));
    k += length;
  }
  return numbers;
}

struct Leaves {
  double cells = 0.0;
  double lowest = 1e9;
  double highest = 0.0;
};

/// From the root down, where the caption looks at the list of cells.
void walk(const Quadtree& tree, std::int32_t cell, Leaves& leaves) {
  const Cell& c = tree.cells[static_cast<std::size_t>(cell)];
  if (c.child >= 0) {
    for (std::int32_t k = 0; k < 4; ++k) walk(tree, c.child + k, leaves);
    return;
  }
  ++leaves.cells;
  if (c.type == CellType::outside) return;
  leaves.lowest = std::min<double>(leaves.lowest, c.density);
  leaves.highest = std::max<double>(leaves.highest, c.density);
}

double liveTriangles(const Mesh& mesh) {
  return static_cast<double>(
      std::count_if(mesh.flags.begin(), mesh.flags.end(), [](std::uint8_t f) { return (f & kDead) == 0; }));
}

double verticesOf(const Mesh& mesh, VertexKind kind) {
  return static_cast<double>(std::count(mesh.kinds.begin(), mesh.kinds.end(), kind));
}

double trianglesWith(const Mesh& mesh, VertexKind kind) {
  double count = 0.0;
  for (const Slot slot : mesh.triangles.keys()) {
    if ((mesh.flags[slot] & kDead) != 0) continue;
    const Corners<Vertex>& v = mesh.triangles[slot].v;
    count += std::any_of(v.begin(), v.end(), [&](Vertex k) { return mesh.kinds[k] == kind; }) ? 1.0 : 0.0;
  }
  return count;
}

double countOf(const std::vector<Event>& events, const std::function<bool(const Event&)>& is) {
  return static_cast<double>(std::count_if(events.begin(), events.end(), is));
}

bool isOf(const Event& e, EventKind kind) { return e.kind == kind; }

/// Points of the boundary that are no end of a curve.
double placedBetween(const MeshState& state) {
  double placed = 0.0;
  for (const BoundaryPoint& p : state.boundary) placed += p.t > 0.0 && p.t < 1.0 ? 1.0 : 0.0;
  return placed;
}

/// What the caption of the stage just left must say, from the events of the stage and the states at both its ends.
std::vector<double> expected(Stage stage, const MeshState& before, const MeshState& after,
                             const std::vector<Event>& events, double changes) {
  const double triangles = liveTriangles(after.mesh);
  const auto points = static_cast<double>(after.mesh.points.size() - before.mesh.points.size());
  Leaves leaves;
  if (!after.tree.cells.empty()) walk(after.tree, 0, leaves);
  switch (stage) {
    case Stage::constraints:
      return {countOf(events, [](const Event& e) { return isOf(e, EventKind::constraint_found); }), after.minEdge};
    case Stage::quadtree:
      return {leaves.cells};
    case Stage::density:
      return {leaves.cells, leaves.lowest, leaves.highest, std::round(after.estimatedTriangles),
              std::stod(bytesText(estimateOf(after).bytes))};
    case Stage::boundary:
      return {placedBetween(after)};
    case Stage::triangulation:
      return {triangles, trianglesWith(after.mesh, VertexKind::helper)};
    case Stage::recovery:
      if (points == 0.0) return {};
      return {verticesOf(after.mesh, VertexKind::split)};
    case Stage::carve:
      return {liveTriangles(before.mesh) - triangles, triangles};
    case Stage::front1:
      return {static_cast<double>(after.front1.size()), triangles};
    case Stage::front2:
      return {static_cast<double>(after.front2.size()), triangles};
    case Stage::repair:
    case Stage::refine:
    case Stage::optimise:
      if (changes == 0.0 && stage == Stage::repair) return {triangles};
      return {changes, triangles};
    default:
      if (points == 0.0) return {triangles};
      return {points, triangles};
  }
}

bool same(const std::vector<double>& said, const std::vector<double>& counted) {
  if (said.size() != counted.size()) return false;
  for (std::size_t k = 0; k < said.size(); ++k)
    if (std::fabs(said[k] - counted[k]) > 5e-4 * std::fabs(counted[k])) return false;
  return true;
}

std::string listOf(const std::vector<double>& numbers) {
  std::string text;
  for (const double n : numbers) text += std::to_string(n) + " ";
  return text;
}

/// Decisions of the stage that changed something, each with its events.
double changesIn(const std::vector<std::vector<Event>>& decisions) {
  return static_cast<double>(std::count_if(decisions.begin(), decisions.end(), [](const std::vector<Event>& made) {
    return std::any_of(made.begin(), made.end(), [](const Event& e) {
      return e.kind != EventKind::stage_begun && e.kind != EventKind::vertex_refused &&
             e.kind != EventKind::vertex_kept && e.kind != EventKind::edit_undone;
    });
  }));
}

struct Left {
  std::vector<std::vector<Event>> decisions;
  std::vector<Event> all;
  Event finished;
};

/// Carries on to the end of the stage that is under way.
Left leaveStage(MeshState& state) {
  Left left;
  const Stage stage = state.stage;
  const std::uint16_t round = state.round;
  std::vector<Event> made;
  Journal journal{&made};
  bool over = false;
  while (!over) {
    made.clear();
    const std::uint64_t tick = state.tick;
    advanceUntil(state, Stage::finished, 1, journal);
    for (const Event& e : made) over = over || e.kind == EventKind::stage_finished;
    if (over) left.finished = made.back();
    left.all.insert(left.all.end(), made.begin(), made.end());
    if (state.tick > tick) left.decisions.push_back(made);
  }
  EXPECT_EQ(left.finished.stage, stage);
  EXPECT_EQ(left.finished.round, refinesMesh(stage) || optimisesMesh(stage) ? left.finished.round : round);
  return left;
}

class StageCaptions : public testing::TestWithParam<const char*> {};

TEST_P(StageCaptions, EveryNumberIsTheState) {
  for (const Settings& settings : {Settings(), support::best(), support::optimised()}) {
    MeshState state = support::start(support::domainAt(support::samples() / GetParam()), settings);
    std::array<StageCounts, kStageCount> counted{};
    while (state.stage != Stage::finished) {
      const MeshState before = state;
      const Left left = leaveStage(state);
      const double changes = changesIn(left.decisions);
      const std::string said = captionOf(left.finished, state);
      const std::vector<double> numbers = numbersIn(said, std::string(infoOf(before.stage).name));
      const std::vector<double> wanted = expected(before.stage, before, state, left.all, changes);
      EXPECT_TRUE(same(numbers, wanted)) << said << "\ncounted: " << listOf(wanted);
      EXPECT_EQ(left.finished.subject, static_cast<std::uint32_t>(changes)) << infoOf(before.stage).name;
      // What the row of the stage says.
      StageCounts& sum = counted[static_cast<std::size_t>(before.stage)];
      const auto add = [&left](std::uint64_t& total, auto... kinds) {
        total +=
            static_cast<std::uint64_t>(countOf(left.all, [=](const Event& e) { return ((e.kind == kinds) || ...); }));
      };
      sum.decisions += left.decisions.size();
      sum.inserted += state.mesh.points.size() - before.mesh.points.size();
      if (before.stage == Stage::triangulation) sum.inserted -= 4;  // the corners of the box around everything
      add(sum.moved, EventKind::vertex_moved);
      add(sum.removed, EventKind::vertex_removed);
      add(sum.refused, EventKind::vertex_refused, EventKind::vertex_kept, EventKind::edit_undone);
      const StageCounts& row = state.counts[before.stage];
      EXPECT_EQ(row.decisions, sum.decisions) << infoOf(before.stage).name;
      EXPECT_EQ(row.inserted, sum.inserted) << infoOf(before.stage).name;
      EXPECT_EQ(row.moved, sum.moved) << infoOf(before.stage).name;
      EXPECT_EQ(row.removed, sum.removed) << infoOf(before.stage).name;
      EXPECT_EQ(row.refused, sum.refused) << infoOf(before.stage).name;
    }
    const Quality quality = measure(state.mesh);
    const std::vector<double> summary = numbersIn(summaryOf(state, quality), "Finished");
    ASSERT_GE(summary.size(), 2u);
    EXPECT_EQ(summary[0], static_cast<double>(state.tick));
    EXPECT_EQ(summary[1], liveTriangles(state.mesh));
  }
}

TEST(StageCaptions, OfARunOverTheLimitSaysWhatItIs) {
  Settings settings;
  settings.maxTriangles = 20;
  MeshState state = support::finished(support::domainFrom(support::kFrame), settings);
  ASSERT_TRUE(state.failed);
  const std::vector<double> said = numbersIn(summaryOf(state, {}), "Stopped");
  ASSERT_EQ(said.size(), 2u);
  EXPECT_GT(said[0], 20.0);
  EXPECT_EQ(said[1], 20.0);
}

INSTANTIATE_TEST_SUITE_P(Samples, StageCaptions, testing::ValuesIn(kSamples),
                         [](const auto& tested) { return std::string(tested.param, std::strcspn(tested.param, ".")); });

}  // namespace
}  // namespace triscope::stage_captions_test
