// Stage "quadtree" (paper, Figure 1 b): cells with a constraint are split until they may hold its density rank, the
// tree is balanced, and the constraints' ranks are written into their leaves.
#include <algorithm>

#include "core/density/sources.h"
#include "core/method/stages/balance.h"
#include "core/method/stages/split_leaf.h"
#include "core/method/stages/stage_runs.h"

namespace triscope {
namespace {

enum QuadtreePhase : std::uint32_t { splitting_for_constraints, balancing_ranks, ranking_constraints };

int wishedRank(const MeshState& state, const Constraint& constraint) {
  const int rank = rankAtMost(constraint.length * state.tree.minEdgeInverse * (1.0 + 1e-12));
  return std::min({rank, state.settings.maxRank, 3 * state.tree.cells[0].rank});
}

// Down the tree to the leaves that constraints hold in, constraint by constraint: index is the constraint, and the
// cells ahead are those still to look at for it. Decided after a leaf that `decide(constraint, leaf)` was true for.
template <class Decide>
Outcome nextLeaf(MeshState& state, const Decide& decide) {
  Cursor& cursor = state.cursor;
  std::vector<std::int32_t>& ahead = cursor.of<CellsAhead>().cells;
  int looked = 0;
  for (; cursor.index < state.constraints.size(); ++cursor.index) {
    const Constraint& constraint = state.constraints[cursor.index];
    const LatticeBox patch = latticeBoxOf(state.tree, reachOf(constraint, *state.domain));
    const bool onePlace = patch.x0 == patch.x1 && patch.y0 == patch.y1;
    if (!cursor.inside) ahead.assign(1, onePlace ? leafAt(state.tree, constraint.at, state.room.placing.path) : 0);
    cursor.inside = true;
    while (!ahead.empty()) {
      if (++looked > kPiece) return Outcome::worked;
      const std::int32_t index = ahead.back();
      ahead.pop_back();
      const Cell& cell = state.tree.cells[static_cast<std::size_t>(index)];
      if (!meets(cell, patch)) continue;
      if (cell.child >= 0) {
        for (std::int32_t k = 4; k-- > 0;) ahead.push_back(cell.child + k);
      } else if (decide(constraint, index)) {
        return Outcome::decided;
      }
    }
    cursor.inside = false;
  }
  return Outcome::done;
}

}  // namespace

Outcome balanceOne(MeshState& state, Journal& journal) {
  std::vector<std::int32_t>& ahead = state.cursor.of<CellsAhead>().cells;
  Quadtree& tree = state.tree;
  for (int looked = 0; !ahead.empty(); ++looked) {
    if (looked == kPiece) return Outcome::worked;
    const std::int32_t leaf = ahead.back();
    const Cell& cell = tree.cells[static_cast<std::size_t>(leaf)];
    if (cell.child < 0) {
      const std::int32_t other = coarseNeighbour(tree, leaf, state.room.placing.path);
      if (other >= 0) {
        const SplitReason why{Rule::balance, static_cast<std::uint32_t>(leaf), cell.rank + 1};
        const std::int32_t first = splitLeaf(state, journal, why, other);
        for (std::int32_t k = 0; k < 4; ++k) ahead.push_back(first + k);
        return Outcome::decided;
      }
    }
    ahead.pop_back();
  }
  return Outcome::done;
}

void queueLeaves(MeshState& state) {
  std::vector<std::int32_t>& ahead = state.cursor.of<CellsAhead>().cells;
  ahead.clear();
  for (std::size_t k = 0; k < state.tree.cells.size(); ++k) {
    if (state.tree.cells[k].child < 0) ahead.push_back(static_cast<std::int32_t>(k));
  }
}

Outcome runQuadtree(MeshState& state, Journal& journal) {
  if (state.failed) return Outcome::done;
  Cursor& cursor = state.cursor;
  cursor.begun = true;
  std::vector<std::int32_t>& ahead = cursor.of<CellsAhead>().cells;
  if (cursor.phase == splitting_for_constraints) {
    const auto split = [&](const Constraint& constraint, std::int32_t leaf) {
      const int largest = largestCellRank(wishedRank(state, constraint));
      if (state.tree.cells[static_cast<std::size_t>(leaf)].rank <= largest) return false;
      const std::int32_t first =
          splitLeaf(state, journal, {constraint.source, static_cast<std::uint32_t>(cursor.index), largest}, leaf);
      for (std::int32_t k = 4; k-- > 0;) ahead.push_back(first + k);
      return true;
    };
    if (const Outcome outcome = nextLeaf(state, split); outcome != Outcome::done) return outcome;
    cursor.phase = balancing_ranks;
    queueLeaves(state);
  }
  if (cursor.phase == balancing_ranks) {
    if (const Outcome outcome = balanceOne(state, journal); outcome != Outcome::done) return outcome;
    cursor.phase = ranking_constraints;
    cursor.index = 0;
  }
  const auto rank = [&](const Constraint& constraint, std::int32_t leaf) {
    Cell& cell = state.tree.cells[static_cast<std::size_t>(leaf)];
    const int wished = wishedRank(state, constraint);
    if (wished >= cell.density) return false;
    if (journal.listening()) {
      Event event = eventIn(state, EventKind::cell_ranked, constraint.source);
      event.subject = static_cast<std::uint32_t>(leaf);
      event.other = static_cast<std::uint32_t>(cursor.index);
      event.measured = wished;
      event.limit = cell.density;
      event.at = constraint.at;
      journal.record(event);
    }
    cell.density = static_cast<std::uint8_t>(wished);
    return true;
  };
  return nextLeaf(state, rank);
}

}  // namespace triscope
