#include "core/method/pipeline.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/base/assert.h"
#include "core/density/quadtree.h"
#include "core/density/sources.h"
#include "core/domain/loop_of.h"
#include "core/domain/shortest_line.h"
#include "core/mesh/validate.h"
#include "core/method/stages/stage_runs.h"
#include "core/method/triangle_limit.h"

namespace triscope {
namespace {

constexpr std::array<StageInfo, kStageCount> kStages = {{
    {Stage::constraints, "constraints", "constraints",
     "finds what asks for short edges: wishes, curvature, corners, gaps, short input edges", "Figure 1 (a)",
     runConstraints},
    {Stage::quadtree, "quadtree", "quadtree",
     "splits cells until each may hold its constraint's density rank, and balances the tree 2:1", "Figure 1 (b)",
     runQuadtree},
    {Stage::density, "density", "density", "spreads the density ranks from the densest cells by an advancing front",
     "Figure 1 (c), (d)", runDensity},
    {Stage::boundary, "boundary points", "boundary", "places points on the boundary, one per edge length",
     "Figure 4 (a)", runBoundary},
    {Stage::triangulation, "triangulation", "triangulation",
     "triangulates the boundary points by Bowyer-Watson insertion", "Figure 4 (b)", runTriangulation},
    {Stage::recovery, "boundary recovery", "recovery",
     "splits boundary edges that the triangulation lacks, until none is missing", "Figure 4 (b)", runRecovery},
    {Stage::carve, "carve", "carve", "removes the triangles outside the domain", "Figure 4 (b)", runCarve},
    {Stage::front1, "first front", "front1", "places the first front of points off the boundary", "Figure 4 (c)",
     runFront1},
    {Stage::front2, "second front", "front2", "places the second front of points off the first", "Figure 4 (c)",
     runFront2},
    {Stage::step1, "step 1", "step1", "inserts circumcentres where R is not below the edge length at the centre",
     "Figure 4 (d)", runSteps},
    {Stage::step2, "step 2", "step2", "inserts circumcentres where R is not below the least edge length at the apexes",
     "", runSteps},
    {Stage::step3, "step 3", "step3",
     "inserts circumcentres where R is not below the shortest edge: angles and edge ratio", "", runSteps},
    {Stage::step4, "step 4", "step4",
     "inserts circumcentres where R is not below a neighbour's shortest edge: area ratio", "", runSteps},
    {Stage::step5, "step 5", "step5",
     "inserts points over shared edges where the neighbour is too tall: area ratio below 3", "Figure 4 (e)", runSteps},
    {Stage::repair, "repair", "repair",
     "mends the triangles that still break a bound, by the best of a few edits around each", "", runRepair},
    {Stage::refine, "step 6", "refine", "moves points: Laplacian filter, obtuse angles, shared edges", "Figure 4 (f)",
     runRefine},
    {Stage::finished, "finished", "finished", "the mesh is done", "Figure 4 (f)", nullptr},
}};

StageCounts& countsOf(MeshState& state) { return state.counts[static_cast<std::size_t>(state.stage)]; }

void recordStage(MeshState& state, EventKind kind, std::uint64_t subject, Journal& journal) {
  if (!journal.listening()) return;
  Event event = eventIn(state, kind, Rule::none);
  event.subject = static_cast<std::uint32_t>(subject);
  journal.record(event);
}

// Steps 2-5 come round again until a whole round inserts nothing; what repair changes calls for another round.
Stage after(const MeshState& state) {
  if (state.failed) return Stage::finished;
  const Settings& s = state.settings;
  const bool again = state.round < s.maxRounds;
  if (state.stage == Stage::step5 && state.roundChanges > 0 && again) return Stage::step2;
  if (state.stage == Stage::repair) {
    if (state.cursor.changes > 0 && again) return Stage::step2;
    return refines(s) ? Stage::refine : Stage::finished;
  }
  return static_cast<Stage>(static_cast<int>(state.stage) + 1);
}

// Empty where nothing is broken. Boundary edges are known to the mesh once it is carved.
[[maybe_unused]] std::string brokenAfter(const MeshState& state) {
  const bool settled = state.stage < Stage::carve || state.failed || state.cursor.changes == 0;
  const std::vector<Violation> found = settled ? std::vector<Violation>{} : validate(state.mesh, 1);
  return found.empty() ? "" : fmt::format("after {} {}", infoOf(state.stage).name, found.front().message);
}

void leaveStage(MeshState& state, Journal& journal) {
  TRISCOPE_DCHECK(brokenAfter(state).empty(), brokenAfter(state));
  recordStage(state, EventKind::stage_finished, state.cursor.changes, journal);
  (state.stage == Stage::refine ? state.passesDone : state.roundsDone) = state.round;
  state.stage = after(state);
  state.cursor = {};
  if (state.stage == Stage::step2) {
    ++state.round;
    state.roundChanges = 0;
  } else if (isPastRounds(state.stage)) {
    state.round = 0;
  }
}

// Cells of side 4Δx are counted in 32 bits. Of a Δx that the geometry asks for the shortest straight edge is named: it
// asked for it, or a curvature or gap beside it did.
Error tooFine(const Domain& domain, double minEdge, double extent, bool byGeometry) {
  Error error;
  error.message = fmt::format("the smallest edge length, {:.3g}, is less than 1/{:.0f} of the domain's extent, {:.6g}",
                              minEdge, kLargestSide, extent);
  error.hint = byGeometry ? "remove or lengthen the domain's smallest details" : "give a larger min_edge_length";
  error.file = domain.file;
  if (!byGeometry) return error;
  const ShortestLine shortest = shortestLine(domain);
  if (shortest.length > extent) return error;
  error.loop = loopOf(domain, shortest.curve).name;
  error.at = domain.curves[shortest.curve].a;
  error.message += fmt::format("; the shortest edge of the domain is {:.3g} long", shortest.length);
  return error;
}

enum class Headway : std::uint8_t { worked, decided, inserted, left_stage, over };

// The smallest move: a decision, or the step from a stage with nothing left to do into the next.
Headway moveOn(MeshState& state, Journal& journal) {
  if (state.stage == Stage::finished) return Headway::over;
  if (!state.cursor.begun) recordStage(state, EventKind::stage_begun, state.round, journal);
  const bool couldGoOn = !state.failed;
  const Outcome outcome = infoOf(state.stage).runOne(state, journal);
  if (outcome == Outcome::worked) return Headway::worked;
  // One look at the state in the stage that it failed in: viewers stay there.
  if (outcome == Outcome::done && couldGoOn && state.failed) return Headway::worked;
  if (outcome == Outcome::done) {
    leaveStage(state, journal);
    return Headway::left_stage;
  }
  ++state.tick;
  ++countsOf(state).decisions;
  if (outcome == Outcome::decided) {
    if (state.stage < Stage::front1) ++state.cursor.changes;  // nothing is refused up to there
    return Headway::decided;
  }
  ++countsOf(state).inserted;
  ++state.cursor.changes;
  ++state.roundChanges;
  if (outgrows(state)) holdToLimit(state, static_cast<double>(state.mesh.liveCount()), journal);
  return Headway::inserted;
}

// True when the grain asked for is complete after a beat that began in `round`.
bool complete(Grain grain, Headway last, const MeshState& state, std::uint16_t round) {
  switch (grain) {
    case Grain::decision:
      return last == Headway::decided || last == Headway::inserted;
    case Grain::insertion:
      return last == Headway::inserted;
    case Grain::stage:
      return last == Headway::left_stage;
    case Grain::round:
      return state.round != round;
    case Grain::all:
      return false;
  }
  return true;
}

}  // namespace

std::span<const StageInfo> stages() { return kStages; }

Result<MeshState> begin(std::shared_ptr<const Domain> domain, const Settings& settings, const SearchNews& goesOn) {
  MeshState state;
  state.settings = settings;
  state.minEdge = settings.minEdge > 0.0 ? settings.minEdge : domain->minEdgeLength;
  if (state.minEdge <= 0.0) {
    const std::optional<double> derived = deriveMinEdge(*domain, settings, goesOn);
    if (!derived) return Error{.kind = ErrorKind::cancelled, .message = "stopped while Δx was derived"};
    state.minEdge = *derived;
    state.minEdgeDerived = true;
  }
  const double extent = std::max(domain->bounds.width(), domain->bounds.height());
  const double finest = state.minEdge > 0.0 ? finestLength(*domain, state.minEdge) : 0.0;
  if (extent > kLargestSide * finest)
    return tooFine(*domain, finest, extent, state.minEdgeDerived || finest < state.minEdge);
  if (state.minEdge > extent) {
    Error error;
    error.message = "the smallest edge length is larger than the whole domain";
    error.hint = "give a min_edge_length well below the domain's extent";
    error.file = domain->file;
    return error;
  }
  // The tree's length is known before its first cell, so that edgeLengthOf() answers at any moment.
  state.tree.minEdge = finest;
  state.tree.minEdgeInverse = 1.0 / finest;
  state.domain = std::move(domain);
  return state;
}

bool advance(MeshState& state, Grain grain, Journal& journal) {
  if (state.stage == Stage::finished) return false;
  const std::uint16_t round = state.round;
  for (;;) {
    const Headway last = moveOn(state, journal);
    if (last == Headway::over || complete(grain, last, state, round)) return true;
  }
}

bool advanceAPiece(MeshState& state, Journal& journal) {
  if (state.stage == Stage::finished) return false;
  Headway last = moveOn(state, journal);
  while (last == Headway::left_stage) last = moveOn(state, journal);
  return true;
}

bool advanceUntil(MeshState& state, Stage stage, std::uint64_t limit, Journal& journal) {
  const auto reached = [&] { return stage == Stage::step5 ? isPastRounds(state.stage) : state.stage > stage; };
  for (; limit > 0 && !reached(); --limit) {
    if (moveOn(state, journal) == Headway::over) break;
  }
  return !reached() && state.stage != Stage::finished;
}

bool advanceUntil(MeshState& state, Stage stage, const std::atomic<bool>& cancel) {
  constexpr std::uint64_t kSlice = 64;
  Journal nobody;
  while (!cancel && advanceUntil(state, stage, kSlice, nobody)) {
  }
  return !cancel;
}

}  // namespace triscope
