#include "core/density/forecast.h"

#include <algorithm>

#include "core/density/sources.h"

namespace triscope {
namespace {

void lower(Quadtree& tree, std::int32_t index, const Box& box, std::uint8_t rank) {
  Cell& cell = tree.cells[static_cast<std::size_t>(index)];
  const Point lo = tree.corner(cell);
  const Point hi = lo + Point{tree.side(cell), tree.side(cell)};
  if (hi.x < box.lo.x || hi.y < box.lo.y || lo.x > box.hi.x || lo.y > box.hi.y) return;
  if (cell.child >= 0) {
    for (std::int32_t k = 0; k < 4; ++k) lower(tree, cell.child + k, box, rank);
  } else if (lo.x >= box.lo.x && lo.y >= box.lo.y && hi.x <= box.hi.x && hi.y <= box.hi.y) {
    cell.density = std::min(cell.density, rank);
  }
}

}  // namespace

Quadtree forecastOf(const Quadtree& tree, const Domain& domain, const Settings& settings, double minEdge) {
  Quadtree end = tree;
  const auto coarsest = static_cast<std::uint8_t>(settings.maxRank);
  for (Cell& cell : end.cells) cell.density = std::min(cell.density, coarsest);
  for (const DensityRequest& request : domain.density) {
    if (request.where != DensityRequest::Where::box) continue;
    const double wish = std::max(lengthWanted(request, minEdge), minEdge);
    lower(end, 0, {request.at, request.to}, static_cast<std::uint8_t>(rankAtMost(wish * tree.minEdgeInverse)));
  }
  return end;
}

double trianglesInTree(const Quadtree& tree) {
  double triangles = 0.0;
  for (const Cell& cell : tree.cells)
    if (cell.child < 0) triangles += trianglesInCell(cell.rank, cell.density);
  return triangles;
}

}  // namespace triscope
