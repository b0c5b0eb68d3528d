// Stage "quadtree" (paper, Figure 1 b): cells with a constraint are split until they may hold its density rank, the
// tree is balanced, and the constraints' ranks are written into their leaves.
#include <algorithm>

#include "core/stages/balance.h"
#include "core/stages/stage_runs.h"

namespace triscope {
namespace {

enum Phase : std::uint32_t { split_for_constraints, balance, rank_constraints };

thread_local LeafPath path;

int wishedRank(const MeshState& state, const Constraint& constraint) {
  const int rank = rankAtMost(constraint.length * state.tree.minEdgeInverse * (1.0 + 1e-12));
  return std::min({rank, state.settings.maxRank, 3 * state.tree.cells[0].rank});
}

}  // namespace

void recordSplit(const MeshState& state, Journal& journal, Rule rule, std::int32_t leaf, std::int32_t first) {
  if (!journal.listening()) return;
  const Cell& cell = state.tree.cells[static_cast<std::size_t>(leaf)];
  Event event = eventIn(state, EventKind::cell_split, rule);
  event.subject = static_cast<std::uint32_t>(leaf);
  event.created = static_cast<std::uint32_t>(first);
  event.createdCount = 4;
  event.measured = cell.rank;
  event.at = state.tree.corner(cell);
  journal.record(event);
}

Outcome balanceOne(MeshState& state, Journal& journal) {
  Cursor& cursor = state.cursor;
  Quadtree& tree = state.tree;
  while (!cursor.worklist.empty()) {
    const std::int32_t leaf = cursor.worklist.back();
    const Cell& cell = tree.cells[static_cast<std::size_t>(leaf)];
    if (cell.child < 0) {
      const std::int32_t other = coarseNeighbour(tree, leaf, path);
      if (other >= 0) {
        const int limit = cell.rank + 1;
        const std::int32_t first = splitCell(tree, other);
        for (std::int32_t k = 0; k < 4; ++k) cursor.worklist.push_back(first + k);
        recordSplit(state, journal, Rule::balance, other, first);
        if (journal.listening()) {
          journal.events->back().other = static_cast<std::uint32_t>(leaf);
          journal.events->back().limit = limit;
        }
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
  Cursor& cursor = state.cursor;
  Quadtree& tree = state.tree;
  cursor.begun = true;
  if (cursor.phase == split_for_constraints) {
    for (; cursor.index < state.constraints.size(); ++cursor.index) {
      const Constraint& constraint = state.constraints[cursor.index];
      const std::int32_t leaf = leafAt(tree, constraint.at, path);
      if (tree.cells[static_cast<std::size_t>(leaf)].rank <= largestCellRank(wishedRank(state, constraint))) continue;
      const std::int32_t first = splitCell(tree, leaf);
      recordSplit(state, journal, constraint.source, leaf, first);
      if (journal.listening()) {
        journal.events->back().other = static_cast<std::uint32_t>(cursor.index);
        journal.events->back().limit = largestCellRank(wishedRank(state, constraint));
      }
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
    const std::int32_t leaf = leafAt(tree, constraint.at, path);
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
