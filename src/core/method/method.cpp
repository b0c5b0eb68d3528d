#include "core/method/method.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/base/capitalised.h"
#include "core/base/stands_by_ids.h"
#include "core/method/stages/stage_runs.h"

namespace triscope {
namespace {

bool roundInserted(const MeshState& state) { return state.roundChanges > 0; }
bool placesBySteps(const Settings& settings) { return !placesByFront(settings.placement); }
// Rows that are optimised need no rounds: no bound of section 3 is as close as what the optimiser aims at.
bool goesRound(const Settings& settings) { return placesBySteps(settings) || !settings.optimise; }
bool placesInRows(const Settings& settings) { return placesByFront(settings.placement); }
bool optimises(const Settings& settings) { return settings.optimise; }
bool stageChanged(const MeshState& state) { return state.cursor.changes > 0; }

/// In the order of Stage.
constexpr std::array kStages = std::to_array<StageInfo>({
    {.id = Stage::constraints,
     .code = 0,
     .group = StageGroup::density,
     .name = "constraints",
     .key = "constraints",
     .does = "finds what asks for short edges: wishes, curvature, corners, gaps, short input edges",
     .rule = "curvature, corners, gaps",
     .figure = "Figure 1 (a)",
     .shade = 0.5,
     .runOne = runConstraints},
    {.id = Stage::quadtree,
     .code = 1,
     .group = StageGroup::density,
     .name = "quadtree",
     .key = "quadtree",
     .does = "splits cells until each may hold its constraint's density rank, and balances the tree 2:1",
     .rule = "splits and balances",
     .figure = "Figure 1 (b)",
     .shade = 0.7,
     .runOne = runQuadtree},
    {.id = Stage::density,
     .code = 2,
     .group = StageGroup::density,
     .name = "density",
     .key = "density",
     .does = "spreads the density ranks from the densest cells by an advancing front",
     .rule = "spreads the ranks",
     .figure = "Figure 1 (c), (d)",
     .shade = 0.9,
     .runOne = runDensity},
    {.id = Stage::boundary,
     .code = 3,
     .group = StageGroup::boundary,
     .name = "boundary points",
     .key = "boundary",
     .does = "places points on the boundary, one per edge length",
     .rule = "one per h",
     .figure = "Figure 4 (a)",
     .shade = 0.5,
     .runOne = runBoundary},
    {.id = Stage::triangulation,
     .code = 4,
     .group = StageGroup::boundary,
     .name = "triangulation",
     .key = "triangulation",
     .does = "triangulates the boundary points by Bowyer-Watson insertion",
     .rule = "Bowyer-Watson",
     .figure = "Figure 4 (b)",
     .shade = 0.65,
     .runOne = runTriangulation},
    {.id = Stage::recovery,
     .code = 5,
     .group = StageGroup::boundary,
     .name = "boundary recovery",
     .key = "recovery",
     .does = "splits boundary edges that the triangulation lacks, until none is missing",
     .rule = "missing edges",
     .figure = "Figure 4 (b)",
     .shade = 0.8,
     .runOne = runRecovery},
    {.id = Stage::carve,
     .code = 6,
     .group = StageGroup::boundary,
     .name = "carve",
     .key = "carve",
     .does = "removes the triangles outside the domain",
     .rule = "outside away",
     .figure = "Figure 4 (b)",
     .shade = 0.95,
     .runOne = runCarve},
    {.id = Stage::front1,
     .code = 7,
     .group = StageGroup::fronts,
     .name = "first front",
     .key = "front1",
     .does = "places the first front of points off the boundary",
     .rule = "off the boundary",
     .figure = "Figure 4 (c)",
     .shade = 0.7,
     .runOne = runFront1,
     .wanted = placesBySteps},
    {.id = Stage::front2,
     .code = 8,
     .group = StageGroup::fronts,
     .name = "second front",
     .key = "front2",
     .does = "places the second front of points off the first",
     .rule = "off the first",
     .figure = "Figure 4 (c)",
     .shade = 1.0,
     .runOne = runFront2,
     .wanted = placesBySteps},
    {.id = Stage::rows,
     .code = 17,
     .group = StageGroup::fronts,
     .name = "rows",
     .key = "rows",
     .does = "places rows of points from the boundary inwards, in place of the two fronts and step 1",
     .rule = "row by row",
     .shade = 0.85,
     .runOne = runRows,
     .wanted = placesInRows},
    {.id = Stage::step1,
     .code = 9,
     .group = StageGroup::filling,
     .name = "step 1",
     .key = "step1",
     .does = "inserts circumcentres where R is not below the edge length at the centre",
     .rule = "R ≥ h(c)",
     .figure = "Figure 4 (d)",
     .shade = 0.5,
     .runOne = runSteps,
     .wanted = placesBySteps},
    {.id = Stage::step2,
     .code = 10,
     .group = StageGroup::rounds,
     .name = "step 2",
     .key = "step2",
     .does = "inserts circumcentres where R is not below the least edge length at the apexes",
     .rule = "R ≥ min h",
     .shade = 0.62,
     .runOne = runSteps,
     .wanted = goesRound},
    {.id = Stage::step3,
     .code = 11,
     .group = StageGroup::rounds,
     .name = "step 3",
     .key = "step3",
     .does = "inserts circumcentres where R is not below the shortest edge: angles and edge ratio",
     .rule = "R ≥ e",
     .shade = 0.74,
     .runOne = runSteps,
     .wanted = goesRound},
    {.id = Stage::step4,
     .code = 12,
     .group = StageGroup::rounds,
     .name = "step 4",
     .key = "step4",
     .does = "inserts circumcentres where R is not below a neighbour's shortest edge: area ratio",
     .rule = "R ≥ e of a neighbour",
     .shade = 0.86,
     .runOne = runSteps,
     .wanted = goesRound},
    {.id = Stage::step5,
     .code = 13,
     .group = StageGroup::rounds,
     .name = "step 5",
     .key = "step5",
     .does = "inserts points over shared edges where the neighbour is too tall: area ratio below 3",
     .rule = "too tall a neighbour",
     .figure = "Figure 4 (e)",
     .shade = 1.0,
     .runOne = runSteps,
     .wanted = goesRound,
     .callsForRound = roundInserted},
    {.id = Stage::repair,
     .code = 14,
     .group = StageGroup::rounds,
     .name = "repair",
     .key = "repair",
     .does = "mends the triangles that still break a bound, by the best of a few edits around each",
     .rule = "what is still broken",
     .shade = 0.85,
     .runOne = runRepair,
     .wanted = goesRound,
     .callsForRound = stageChanged},
    {.id = Stage::refine,
     .code = 15,
     .group = StageGroup::refinement,
     .name = "step 6",
     .key = "refine",
     .does = "moves points: Laplacian filter, obtuse angles, shared edges",
     .rule = "moves and flips",
     .figure = "Figure 4 (f)",
     .shade = 0.9,
     .runOne = runRefine,
     .wanted = refines},
    {.id = Stage::optimise,
     .code = 18,
     .group = StageGroup::optimisation,
     .name = "optimise",
     .key = "optimise",
     .does = "moves, flips, merges and splits until no angle or ratio is beyond what the dial asks for",
     .rule = "beyond the dial",
     .shade = 0.9,
     .runOne = runOptimise,
     .wanted = optimises},
    {.id = Stage::finished,
     .code = 16,
     .group = StageGroup::end,
     .name = "finished",
     .key = "finished",
     .does = "the mesh is done",
     .shade = 0.5},
});
static_assert(kStages.size() == static_cast<std::size_t>(kStageCount));
static_assert(standsByIds(kStages) && std::ranges::is_sorted(kStages, {}, &StageInfo::group));

/// All but the end.
constexpr std::array kPaperStages = [] {
  std::array<Stage, kStages.size() - 1> all{};
  for (std::size_t k = 0; k < all.size(); ++k) all[k] = kStages[k].id;
  return all;
}();
constexpr Method kPaperMethod{"the paper's", kPaperStages};

/// What a group is called on the command line, and what it goes through again and again.
struct GroupWords {
  StageGroup id;
  std::string_view key;
  std::string_view turn;
  std::string_view turnsOf;  // empty: of the stage
};
constexpr std::array kGroups{
    GroupWords{StageGroup::fronts, "fronts", "", ""},
    GroupWords{StageGroup::rounds, "rounds", "round", "steps 2 to 5"},
    GroupWords{StageGroup::refinement, "", "pass", ""},
    GroupWords{StageGroup::optimisation, "", "pass", ""},
};

constexpr GroupWords wordsOf(StageGroup group) {
  const auto* const found = std::ranges::find(kGroups, group, &GroupWords::id);
  return found == kGroups.end() ? GroupWords{group, "", "", ""} : *found;
}

std::string turnOf(const GroupWords& group, int turn) {
  return group.turn.empty() || turn == 0 ? std::string() : fmt::format("{} {}", group.turn, turn);
}

bool isRun(const StageInfo& info, const Settings& settings) { return info.wanted == nullptr || info.wanted(settings); }

/// Whether a stage is run at all is decided when the last before it that is run with either settings ends.
Stage decidedAfter(Stage stage, const Settings& a, const Settings& b) {
  auto k = static_cast<std::size_t>(stage);
  while (k > 0 && !(isRun(kStages[k], a) && isRun(kStages[k], b))) --k;
  return kStages[k].id;
}

}  // namespace

std::span<const StageInfo> stages() { return kStages; }

double shortestMeant(const MeshState& state) {
  const Settings& settings = state.settings;
  const bool optimised = settings.optimise && state.stage >= Stage::optimise;
  const bool byRatio = optimised || settings.size == SizeField::continuous || placesByFront(settings.placement);
  return byRatio ? 0.5 * state.minEdge : state.minEdge;
}

const Method& paperMethod() { return kPaperMethod; }

std::string_view groupKey(StageGroup group) { return wordsOf(group).key; }

std::string turnText(Stage stage, int turn) { return turnOf(wordsOf(infoOf(stage).group), turn); }

std::string turnBehind(Stage stage, int turn) {
  const std::string text = turnText(stage, turn);
  return text.empty() ? text : ", " + text;
}

std::string turnHeading(Stage stage, int turn) {
  const StageInfo& info = infoOf(stage);
  const GroupWords group = wordsOf(info.group);
  const std::string text = turnOf(group, turn);
  if (text.empty()) return {};
  return fmt::format("{} of {}", capitalised(text), group.turnsOf.empty() ? info.name : group.turnsOf);
}

Stage firstAffected(const Settings& a, const Settings& b) {
  Stage first = Stage::finished;
  for (const SettingInfo& info : settingTable())
    if (settingValue(a, info) != settingValue(b, info)) first = std::min(first, info.firstStage);
  for (const StageInfo& info : kStages)
    if (isRun(info, a) != isRun(info, b)) first = std::min(first, decidedAfter(info.id, a, b));
  return first;
}

}  // namespace triscope
