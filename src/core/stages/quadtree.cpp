// Stage "quadtree" (paper, Figure 1 b): cells with a constraint are split until they may hold its density rank, the
// tree is balanced, and the constraints' ranks are written into their leaves.
#include <algorithm>

#include "core/stages/balance.h"
#include "core/stages/split_leaf.h"
#include "core/stages/stage_runs.h"

namespace triscope {
namespace {

enum Phase : std::uint32_t { split_for_constraints, balance, rank_constraints };

int wishedRank(const MeshState& state, const Constraint& constraint) {
  const int rank = rankAtMost(constraint.length * state.tree.minEdgeInverse * (1.0 + 1e-12));
  return std::min({rank, state.settings.maxRank, 3 * state.tree.cells[0].rank});
}

}  // namespace

Outcome balanceOne(MeshState& state, Journal& journal) {
  Cursor& cursor = state.cursor;
  Quadtree& tree = state.tree;
  thread_local std::vector<std::int32_t> around;
  while (!cursor.worklist.empty()) {
    const std::int32_t leaf = cursor.worklist.back();
    const Cell& cell = tree.cells[static_cast<std::size_t>(leaf)];
    if (cell.child < 0) {
      neighboursOf(tree, leaf, around);
      for (const std::int32_t other : around) {
        const Cell& neighbour = tree.cells[static_cast<std::size_t>(other)];
        if (neighbour.rank <= cell.rank + 1) continue;
        const SplitReason why{Rule::balance, static_cast<std::uint32_t>(leaf), cell.rank + 1};
        const std::int32_t first = splitLeaf(state, journal, why, other);
        for (std::int32_t k = 0; k < 4; ++k) cursor.worklist.push_back(first + k);
        return Outcome::decided;
      }
    }
    cursor.worklist.pop_back();
  }
  return Outcome::done;
}

void queueLeaves(MeshState& state) {
  state.cursor.worklist.clear();
  for (std::size_t k = 0; k < state.tree.cells.size(); ++k) {
    if (state.tree.cells[k].child < 0) state.cursor.worklist.push_back(static_cast<std::int32_t>(k));
  }
}

Outcome runQuadtree(MeshState& state, Journal& journal) {
  if (state.failed) return Outcome::done;
  Cursor& cursor = state.cursor;
  Quadtree& tree = state.tree;
  cursor.begun = true;
  if (cursor.phase == split_for_constraints) {
    for (; cursor.index < state.constraints.size(); ++cursor.index) {
      const Constraint& constraint = state.constraints[cursor.index];
      const std::int32_t leaf = leafAt(tree, constraint.at);
      const int largest = largestCellRank(wishedRank(state, constraint));
      if (tree.cells[static_cast<std::size_t>(leaf)].rank <= largest) continue;
      splitLeaf(state, journal, {constraint.source, static_cast<std::uint32_t>(cursor.index), largest}, leaf);
      return Outcome::decided;
    }
    cursor.phase = balance;
    queueLeaves(state);
  }
  if (cursor.phase == balance) {
    if (balanceOne(state, journal) == Outcome::decided) return Outcome::decided;
    cursor.phase = rank_constraints;
    cursor.index = 0;
  }
  for (; cursor.index < state.constraints.size(); ++cursor.index) {
    const Constraint& constraint = state.constraints[cursor.index];
    const std::int32_t leaf = leafAt(tree, constraint.at);
    Cell& cell = tree.cells[static_cast<std::size_t>(leaf)];
    const int rank = wishedRank(state, constraint);
    if (rank >= cell.density) continue;
    if (journal.listening()) {
      Event event = eventIn(state, EventKind::cell_ranked, constraint.source);
      event.subject = static_cast<std::uint32_t>(leaf);
      event.other = static_cast<std::uint32_t>(cursor.index);
      event.measured = rank;
      event.limit = cell.density;
      event.at = constraint.at;
      journal.record(event);
    }
    cell.density = static_cast<std::uint8_t>(rank);
    ++cursor.index;
    return Outcome::decided;
  }
  return Outcome::done;
}

}  // namespace triscope
