#include "core/density/forecast.h"

#include <algorithm>

#include "core/density/sources.h"

namespace triscope {
namespace {

struct Wish {
  Box box;
  std::uint8_t rank = 0;
};

// Of boxes that hold a cell as a whole only the lowest rank goes further down.
void lower(const Quadtree& tree, std::int32_t index, const std::vector<Wish>& wishes, std::uint8_t rank,
           std::vector<std::uint8_t>& ranks) {
  const Cell& cell = tree.cells[static_cast<std::size_t>(index)];
  const Point lo = tree.corner(cell);
  const Point hi = lo + Point{tree.side(cell), tree.side(cell)};
  std::vector<Wish> partly;
  for (const Wish& wish : wishes) {
    const Box& box = wish.box;
    if (hi.x < box.lo.x || hi.y < box.lo.y || lo.x > box.hi.x || lo.y > box.hi.y || wish.rank >= rank) continue;
    if (lo.x >= box.lo.x && lo.y >= box.lo.y && hi.x <= box.hi.x && hi.y <= box.hi.y)
      rank = wish.rank;
    else
      partly.push_back(wish);
  }
  if (cell.child < 0) {
    ranks[static_cast<std::size_t>(index)] = std::min(cell.density, rank);
    return;
  }
  for (std::int32_t k = 0; k < 4; ++k) lower(tree, cell.child + k, partly, rank, ranks);
}

}  // namespace

std::vector<std::uint8_t> forecastOf(const Quadtree& tree, const Domain& domain, const Settings& settings,
                                     double minEdge) {
  std::vector<Wish> wishes;
  for (const DensityRequest& request : domain.density) {
    if (request.where != DensityRequest::Where::box) continue;
    const double wish = std::max(lengthWanted(request, minEdge), minEdge);
    const int rank = rankAtMost(wish * tree.minEdgeInverse * (1.0 + 1e-12));
    wishes.push_back({{request.at, request.to}, static_cast<std::uint8_t>(rank)});
  }
  std::vector<std::uint8_t> ranks(tree.cells.size());
  lower(tree, 0, wishes, static_cast<std::uint8_t>(settings.maxRank), ranks);
  return ranks;
}

double trianglesInTree(const Quadtree& tree, const std::vector<std::uint8_t>& ranks) {
  double triangles = 0.0;
  for (std::size_t k = 0; k < tree.cells.size(); ++k)
    if (tree.cells[k].child < 0) triangles += trianglesInCell(tree.cells[k].rank, ranks[k]);
  return triangles;
}

}  // namespace triscope
