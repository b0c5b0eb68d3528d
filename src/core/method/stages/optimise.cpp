// Stage "optimise", our own: the mesh that one takes home. Its passes smooth the vertices, bring dislocations to meet,
// improve shapes, lead back what is beyond the aims of the dial, and edit around what that does not cure. Between two
// passes the mesh is Delaunay.
#include <array>

#include "core/density/continuous_size.h"
#include "core/method/stages/optimise_cure.h"
#include "core/method/stages/optimise_parts.h"
#include "core/method/stages/vertex_sizes.h"

namespace triscope {
namespace {

struct Pass {
  Outcome (*run)(Optimiser&);
  void (*begin)(Optimiser&) = nullptr;
  bool onlyAfterChanges = false;  // of the pass before
};

void forgetStill(Optimiser& o) { o.ahead.still.assign(o.state.mesh.points.size(), 0); }
void countExcess(Optimiser& o) { o.ahead.excess = excessOf(o.state.mesh); }

constexpr Pass kSmooth{runSmooth};
constexpr Pass kShape{runShape};
constexpr Pass kFlips{runFlips};
constexpr Pass kCure{runCure, beginCure};

/// Each with its part of Event::round, from 1.
constexpr std::array kOptimiserPasses = std::to_array<Pass>({
    {runSmooth, forgetStill},
    kFlips,
    kSmooth,
    kFlips,
    {runAnneal, countExcess},
    {runAnneal, nullptr, true},
    kSmooth,
    kFlips,
    {runShape, forgetStill},
    kFlips,
    kShape,
    kFlips,
    kShape,
    kFlips,
    kShape,
    kFlips,
    kShape,
    kFlips,
    kShape,
    kFlips,
    {runRelax, beginRelax},
    kCure,
    {runCure, beginCure, true},
    {runCure, beginCure, true},
    {runCurePairs, beginCurePairs},
});

void beginOptimising(MeshState& state) {
  state.cursor.begun = true;
  const Quadtree& tree = state.tree;
  extendSizes(state, tree.corners.empty() ? continuousLengths(tree) : tree.corners);
  fitSizes(state);
}

void beginPass(Optimiser& o) {
  o.state.round = static_cast<std::uint16_t>(o.state.cursor.phase + 1);
  o.state.cursor.index = 0;
  o.ahead.changesBefore = o.state.cursor.changes;
  if (const auto& pass = kOptimiserPasses[o.state.cursor.phase]; pass.begin != nullptr) pass.begin(o);
}

}  // namespace

int optimiserPasses() { return static_cast<int>(kOptimiserPasses.size()); }

Outcome runOptimise(MeshState& state, Journal& journal) {
  // phase: the pass, from 0; index: where it is.
  Cursor& cursor = state.cursor;
  Optimising& ahead = cursor.of<Optimising>();
  Optimiser o{state, ahead, journal, {state.mesh, state.sizes, state.domain->curves, state.room.optimiser}};
  if (!cursor.begun) {
    beginOptimising(state);
    beginPass(o);
  }
  while (cursor.phase < kOptimiserPasses.size()) {
    const Outcome outcome = kOptimiserPasses[cursor.phase].run(o);
    if (outcome != Outcome::done) return outcome;
    const bool changed = cursor.changes != ahead.changesBefore;
    do ++cursor.phase;
    while (cursor.phase < kOptimiserPasses.size() && !changed && kOptimiserPasses[cursor.phase].onlyAfterChanges);
    if (cursor.phase < kOptimiserPasses.size()) beginPass(o);
  }
  state.sizes = {};
  return Outcome::done;
}

}  // namespace triscope
