#include "core/stages/split_leaf.h"

#include <bit>

#include "core/density/classify.h"
#include "core/density/forecast.h"
#include "core/stages/stage_runs.h"
#include "core/triangle_limit.h"

namespace triscope {
namespace {

constexpr std::size_t kFirstLook = std::size_t{1} << 16u;  // cells: a smaller tree is built in no time

// Trees have 4k + 1 cells.
bool due(std::size_t cells) {
  return cells > kFirstLook && std::bit_floor(cells) == cells - 1 && std::countr_zero(cells - 1) % 2 == 0;
}

// Ranks only fall and cells are only split from here on, so that no leaf ends with fewer triangles than now. A tree of
// more cells than triangles that are allowed lies outside the domain for the most part, and takes as much memory.
void lookAhead(MeshState& state, Journal& journal) {
  const double most = state.settings.maxTriangles;
  const auto cells = static_cast<double>(state.tree.cells.size());
  Quadtree end = forecastOf(state.tree, *state.domain, state.settings, state.minEdge);
  if (trianglesInTree(end) <= most) return;
  const double triangles = classifyCells(end, *state.domain);
  holdToLimit(state, triangles > most ? triangles : cells, journal);
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
  if (due(state.tree.cells.size())) lookAhead(state, journal);
  return first;
}

void holdToLimit(MeshState& state, double triangles, Journal& journal) {
  const double most = state.settings.maxTriangles;
  if (triangles <= most) return;
  state.estimatedTriangles = triangles;
  state.failed = true;
  if (!journal.listening()) return;
  const Asker asker = askerOf(state);
  Event event = eventIn(state, EventKind::failure, asker.source);
  event.refusal = Refusal::too_many_triangles;
  event.other = asker.curve;
  event.measured = triangles;
  event.limit = most;
  event.at = asker.at;
  journal.record(event);
}

}  // namespace triscope
