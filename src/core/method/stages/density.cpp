// Stage "density" (paper, Figure 1 c, d): an advancing front from the densest cells gives every cell its rank, at most
// one more than its neighbour's; cells too large for their rank are split.
#include <algorithm>

#include "core/density/classify.h"
#include "core/density/continuous_size.h"
#include "core/method/stages/balance.h"
#include "core/method/stages/split_leaf.h"
#include "core/method/stages/stage_runs.h"
#include "core/method/triangle_limit.h"

namespace triscope {
namespace {

enum DensityPhase : std::uint32_t { advancing_front, balancing_densities, classifying, classified };
constexpr std::size_t kRanks = 256;

void push(MeshState& state, std::int32_t leaf) {
  Cursor& cursor = state.cursor;
  RankFront& front = cursor.of<RankFront>();
  const std::size_t rank = state.tree.cells[static_cast<std::size_t>(leaf)].density;
  const auto entry = static_cast<std::int32_t>(front.entries.size());
  front.entries.push_back({leaf, front.first[rank]});
  front.first[rank] = entry;
  cursor.index = std::min<std::uint64_t>(cursor.index, rank);
}

void begin(MeshState& state) {
  Cursor& cursor = state.cursor;
  cursor.begun = true;
  cursor.of<RankFront>().first.assign(kRanks, -1);
  cursor.index = kRanks;
  for (std::size_t k = state.tree.cells.size(); k-- > 0;) {
    const Cell& cell = state.tree.cells[k];
    if (cell.child < 0 && cell.density < 3 * cell.rank) push(state, static_cast<std::int32_t>(k));
  }
  if (cursor.index == kRanks) push(state, 0);
}

Outcome rankNeighbour(MeshState& state, std::int32_t leaf, std::int32_t other, Journal& journal) {
  Quadtree& tree = state.tree;
  Cell& a = tree.cells[static_cast<std::size_t>(leaf)];
  Cell& b = tree.cells[static_cast<std::size_t>(other)];
  const int before = b.density;
  int rank = std::min<int>({before, a.density + 1, state.settings.maxRank});
  if (b.rank > largestCellRank(rank)) {
    splitLeaf(state, journal, {Rule::advancing_front, static_cast<std::uint32_t>(leaf), largestCellRank(rank)}, other);
    return Outcome::decided;
  }
  if (b.rank < smallestCellRank(rank)) rank = a.density;
  b.density = static_cast<std::uint8_t>(rank);
  b.visited = 1;
  push(state, other);
  if (journal.listening()) {
    Event event = eventIn(state, EventKind::cell_ranked, Rule::advancing_front);
    event.subject = static_cast<std::uint32_t>(other);
    event.other = static_cast<std::uint32_t>(leaf);
    event.measured = rank;
    event.limit = before;
    const double half = 0.5 * tree.side(b);
    event.at = tree.corner(b) + Point{half, half};
    journal.record(event);
  }
  return Outcome::decided;
}

Outcome advanceFront(MeshState& state, Journal& journal) {
  Cursor& cursor = state.cursor;
  RankFront& front = cursor.of<RankFront>();
  for (int looked = 0; cursor.index < kRanks; ++looked) {
    if (looked == kPiece) return Outcome::worked;
    const std::int32_t first = front.first[cursor.index];
    if (first < 0) {
      ++cursor.index;
      continue;
    }
    const auto [leaf, next] = front.entries[static_cast<std::size_t>(first)];
    Cell& cell = state.tree.cells[static_cast<std::size_t>(leaf)];
    const bool stale = cell.child >= 0 || cell.density != cursor.index;
    if (!stale) {
      cell.visited = 1;
      const std::int32_t other = unvisitedNeighbour(state.tree, leaf, state.room.placing.path);
      if (other >= 0) return rankNeighbour(state, leaf, other, journal);
    }
    front.first[cursor.index] = next;
  }
  return Outcome::done;
}

}  // namespace

Outcome runDensity(MeshState& state, Journal& journal) {
  if (state.failed) return Outcome::done;
  Cursor& cursor = state.cursor;
  if (!cursor.begun) begin(state);
  if (cursor.phase == advancing_front) {
    if (const Outcome outcome = advanceFront(state, journal); outcome != Outcome::done) return outcome;
    cursor.phase = balancing_densities;
    queueLeaves(state);
  }
  if (cursor.phase == balancing_densities) {
    if (const Outcome outcome = balanceOne(state, journal); outcome != Outcome::done) return outcome;
    cursor.phase = classifying;
  }
  if (cursor.phase == classifying) {
    state.estimatedTriangles = classifyCells(state.tree, *state.domain);
    if (state.settings.size == SizeField::continuous) state.tree.corners = continuousLengths(state.tree);
    cursor.phase = classified;
    holdToLimit(state, state.estimatedTriangles, journal);
  }
  return Outcome::done;
}

}  // namespace triscope
