#include "core/method/stages/split_leaf.h"

#include <algorithm>
#include <bit>

#include "core/density/classify.h"
#include "core/density/forecast.h"
#include "core/method/stages/stage_runs.h"
#include "core/method/triangle_limit.h"

namespace triscope {
namespace {

constexpr std::size_t kFirstLook = std::size_t{1} << 16u;    // cells: a smaller tree is built in no time
constexpr std::size_t kFewestCells = std::size_t{1} << 20u;  // allowed in any case: they take a few megabytes

// Ranks only fall and cells are only split from here on, so that no leaf ends with fewer triangles than now. A leaf in
// the domain has a dozen at least: a tree of more cells than triangles that are allowed lies outside for the most part.
void lookAhead(MeshState& state, Journal& journal) {
  const std::size_t cells = state.tree.cells.size();
  const auto most = static_cast<std::size_t>(state.settings.maxTriangles);
  if (cells > std::max(most, kFewestCells)) return holdToLimit(state, static_cast<double>(cells), journal);
  const bool fourfold = std::bit_floor(cells) == cells - 1 && std::countr_zero(cells - 1) % 2 == 0;  // cells: 4k + 1
  if (cells < kFirstLook || !fourfold) return;
  const std::vector<std::uint8_t> ranks = forecastOf(state.tree, *state.domain, state.settings, state.minEdge);
  if (trianglesInTree(state.tree, ranks) <= state.settings.maxTriangles) return;
  Quadtree end = state.tree;
  for (std::size_t k = 0; k < cells; ++k) end.cells[k].density = ranks[k];
  holdToLimit(state, classifyCells(end, *state.domain), journal);
}

}  // namespace

std::int32_t splitLeaf(MeshState& state, Journal& journal, const SplitReason& why, std::int32_t leaf) {
  const std::int32_t first = splitCell(state.tree, leaf);
  if (journal.listening()) {
    const Cell& cell = state.tree.cells[static_cast<std::size_t>(leaf)];
    Event event = eventIn(state, EventKind::cell_split, why.rule);
    event.subject = static_cast<std::uint32_t>(leaf);
    event.other = why.asker;
    event.created = static_cast<std::uint32_t>(first);
    event.createdCount = 4;
    event.measured = cell.rank;
    event.limit = why.limit;
    event.at = state.tree.corner(cell);
    journal.record(event);
  }
  lookAhead(state, journal);
  return first;
}

}  // namespace triscope
