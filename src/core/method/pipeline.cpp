#include "core/method/pipeline.h"

#include <fmt/format.h>

#include <algorithm>

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

StageCounts& countsOf(MeshState& state) { return state.counts[state.stage]; }

void recordStage(MeshState& state, EventKind kind, std::uint64_t subject, Journal& journal) {
  if (!journal.listening()) return;
  Event event = eventIn(state, kind, Rule::none);
  event.subject = static_cast<std::uint32_t>(subject);
  journal.record(event);
}

Stage beginOfRounds(const Method& method) {
  const auto first = std::ranges::find_if(method.stages, inRounds);
  return first == method.stages.end() ? Stage::finished : *first;
}

// Rounds come again until a whole one inserts nothing; what repair changes calls for another round.
Stage after(const MeshState& state) {
  if (state.failed) return Stage::finished;
  const StageInfo& info = infoOf(state.stage);
  const bool again = info.callsForRound != nullptr && info.callsForRound(state);
  if (again && state.round < state.settings.maxRounds) return beginOfRounds(*state.method);
  for (const Stage next : state.method->stages) {
    const auto wanted = infoOf(next).wanted;
    if (next > state.stage && (wanted == nullptr || wanted(state.settings))) return next;
  }
  return Stage::finished;
}

// Empty where nothing is broken. Boundary edges are known to the mesh once it is carved.
[[maybe_unused]] std::string brokenAfter(const MeshState& state) {
  const bool settled = !isCarved(after(state)) || state.failed || state.cursor.changes == 0;
  const std::vector<Violation> found = settled ? std::vector<Violation>{} : validate(state.mesh, 1);
  return found.empty() ? "" : fmt::format("after {} {}", infoOf(state.stage).name, found.front().message);
}

void leaveStage(MeshState& state, Journal& journal) {
  TRISCOPE_DCHECK(brokenAfter(state).empty(), brokenAfter(state));
  recordStage(state, EventKind::stage_finished, state.cursor.changes, journal);
  if (refinesMesh(state.stage))
    state.passesDone += state.round;
  else if (inRounds(state.stage))
    state.roundsDone = state.round;
  state.stage = after(state);
  state.cursor = {};
  if (inRounds(state.stage) && state.stage == beginOfRounds(*state.method)) {
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
    if (!isCarved(state.stage)) ++state.cursor.changes;  // nothing is refused up to there
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

Result<MeshState> begin(std::shared_ptr<const Domain> domain, const Settings& settings, const SearchNews& goesOn,
                        const Method& method) {
  MeshState state;
  state.method = &method;
  state.stage = method.stages.front();
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
  const bool rounds = infoOf(stage).callsForRound != nullptr;
  const auto reached = [&] { return rounds ? isPastRounds(state.stage) : state.stage > stage; };
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
