#include "core/density/classify.h"

#include <algorithm>

#include "core/density/boundary_tree.h"
#include "core/geometry/trig.h"

namespace triscope {
namespace {

// True when the closed segment meets the closed square (separating axes).
bool segmentMeetsSquare(Point a, Point b, Point corner, double side) {
  if (std::max(a.x, b.x) < corner.x || std::min(a.x, b.x) > corner.x + side) return false;
  if (std::max(a.y, b.y) < corner.y || std::min(a.y, b.y) > corner.y + side) return false;
  const Point d = b - a;
  const double s00 = cross(d, corner - a);
  const double s10 = cross(d, corner + Point{side, 0} - a);
  const double s01 = cross(d, corner + Point{0, side} - a);
  const double s11 = cross(d, corner + Point{side, side} - a);
  return std::min({s00, s10, s01, s11}) <= 0.0 && std::max({s00, s10, s01, s11}) >= 0.0;
}

void markBoundary(Quadtree& tree, std::int32_t index, const BoundaryPiece& piece) {
  Cell& cell = tree.cells[static_cast<std::size_t>(index)];
  if (!segmentMeetsSquare(piece.a, piece.b, tree.corner(cell), tree.side(cell))) return;
  if (cell.child < 0) {
    cell.type = CellType::boundary;
    return;
  }
  for (std::int32_t k = 0; k < 4; ++k) markBoundary(tree, cell.child + k, piece);
}

}  // namespace

double classifyCells(Quadtree& tree, const Domain& domain) {
  const BoundaryTree boundary = boundaryTreeOf(domain, 10.0 * trig::kDegree);
  for (Cell& cell : tree.cells) cell.type = CellType::outside;
  for (const BoundaryPiece& piece : boundary.pieces) markBoundary(tree, 0, piece);

  // Leaves without boundary are inside or outside as a whole, and so are their neighbours of the same kind: one
  // point-in-domain test decides a whole region.
  std::vector<std::uint8_t> seen(tree.cells.size(), 0);
  std::vector<std::int32_t> stack, around;
  LeafPath path;
  for (std::size_t k = 0; k < tree.cells.size(); ++k) {
    if (tree.cells[k].child >= 0 || seen[k] != 0 || tree.cells[k].type == CellType::boundary) continue;
    const double half = 0.5 * tree.side(tree.cells[k]);
    const bool inside = insideDomain(boundary, tree.corner(tree.cells[k]) + Point{half, half});
    stack.assign(1, static_cast<std::int32_t>(k));
    seen[k] = 1;
    while (!stack.empty()) {
      const std::int32_t leaf = stack.back();
      stack.pop_back();
      neighboursOf(tree, leaf, path, around);
      bool byBoundary = false;
      for (const std::int32_t other : around) {
        const auto o = static_cast<std::size_t>(other);
        if (tree.cells[o].type == CellType::boundary) {
          byBoundary = true;
        } else if (seen[o] == 0) {
          seen[o] = 1;
          stack.push_back(other);
        }
      }
      tree.cells[static_cast<std::size_t>(leaf)].type = !inside      ? CellType::outside
                                                        : byBoundary ? CellType::adjacent_boundary
                                                                     : CellType::white;
    }
  }

  double estimate = 0.0;
  for (const Cell& cell : tree.cells) {
    if (cell.child >= 0 || cell.type == CellType::outside) continue;
    double part = 1.0;
    if (cell.type == CellType::boundary) {
      int count = 0;
      const double step = 0.25 * tree.side(cell);
      for (int k = 0; k < 16; ++k) {
        const int column = k % 4;
        const int row = k / 4;
        const Point sample = tree.corner(cell) + Point{(column + 0.5) * step, (row + 0.5) * step};
        if (insideDomain(boundary, sample)) ++count;
      }
      part = count / 16.0;
    }
    estimate += part * trianglesInCell(cell.rank, cell.density);
  }
  return estimate;
}

}  // namespace triscope
