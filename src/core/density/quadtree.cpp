#include "core/density/quadtree.h"

#include <algorithm>
#include <array>
#include <bit>

#include "core/base/assert.h"
#include "core/density/continuous_size.h"

namespace triscope {
namespace {

// 2^(1/3) and 2^(2/3), correctly rounded (the paper's k = 1.26 and k² = 1.5876, before rounding).
constexpr std::array<double, 3> kThird = {1.0, 1.2599210498948732, 1.5874010519681994};

const Cell& cellAt(const Quadtree& tree, std::int32_t index) { return tree.cells[static_cast<std::size_t>(index)]; }

double powerOfTwo(int exponent) { return static_cast<double>(1ull << exponent); }

constexpr std::array<double, 192> kRankLengths = [] {
  std::array<double, 192> lengths{};
  for (std::size_t i = 0; i < lengths.size(); ++i) lengths[i] = kThird[i % 3] * static_cast<double>(1ull << (i / 3));
  return lengths;
}();

// Square of rank-1 side so far from the root's corner along an axis.
std::uint32_t latticeOf(const Quadtree& tree, double distance) {
  const std::uint32_t all = 1u << (cellAt(tree, 0).rank - 1);
  const double s = distance * (0.25 * tree.minEdgeInverse);
  if (!(s > 0.0)) return 0;
  return s >= static_cast<double>(all) ? all - 1 : static_cast<std::uint32_t>(s);
}

bool holds(const Cell& cell, std::uint32_t x, std::uint32_t y) {
  const std::uint32_t side = 1u << (cell.rank - 1);
  return x - cell.x < side && y - cell.y < side;  // what is less wraps round to much more
}

}  // namespace

// The search begins at the smallest cell of the path that may hold the square: any cell that does lies above the leaf.
std::int32_t leafOver(const Quadtree& tree, std::uint32_t x, std::uint32_t y, LeafPath& path) {
  const std::size_t count = tree.cells.size();
  if (static_cast<std::size_t>(path.leaf) < count) {
    const Cell& last = cellAt(tree, path.leaf);
    if (last.child < 0 && holds(last, x, y)) return path.leaf;
  }
  const auto differing = static_cast<std::size_t>(std::bit_width((x ^ path.x) | (y ^ path.y)));
  std::int32_t index = path.cells[differing + 1];
  if (static_cast<std::size_t>(index) >= count || !holds(cellAt(tree, index), x, y)) index = 0;
  for (;;) {
    const Cell& cell = cellAt(tree, index);
    path.cells[cell.rank] = index;
    if (cell.child < 0) break;
    const int shift = cell.rank - 2;
    index = cell.child + static_cast<std::int32_t>((x >> shift & 1u) | (y >> shift & 1u) << 1);
  }
  path.leaf = index;
  path.x = x;
  path.y = y;
  return index;
}

double rankLength(int densityRank) { return kRankLengths[static_cast<std::size_t>(densityRank - 1)]; }

double edgeLengthOf(const Quadtree& tree, int densityRank) { return tree.minEdge * rankLength(densityRank); }

int rankAtMost(double lengthInMinEdges) {
  int rank = 1;
  while (rank < 96 && rankLength(rank + 1) <= lengthInMinEdges) ++rank;
  return rank;
}

int smallestCellRank(int densityRank) { return (densityRank + 2) / 3; }
int largestCellRank(int densityRank) { return densityRank / 3 + 1; }

double trianglesInCell(int cellRank, int densityRank) {
  const double ratio = 4.0 * powerOfTwo(cellRank - 1) / rankLength(densityRank);
  return 2.0 * ratio * ratio;
}

Quadtree rootOver(const Box& box, double minEdge) {
  Quadtree tree;
  tree.minEdge = minEdge;
  tree.minEdgeInverse = 1.0 / minEdge;
  Cell root;
  const double extent = std::max(box.width(), box.height());
  while (tree.side(root) < extent) ++root.rank;
  root.density = static_cast<std::uint8_t>(3 * root.rank);
  const double half = 0.5 * tree.side(root);
  tree.origin = midpoint(box.lo, box.hi) - Point{half, half};
  tree.cells.push_back(root);
  return tree;
}

std::int32_t splitCell(Quadtree& tree, std::int32_t leaf) {
  const auto first = static_cast<std::int32_t>(tree.cells.size());
  const Cell parent = cellAt(tree, leaf);
  TRISCOPE_CHECK(parent.child < 0 && parent.rank > 1, "a cell is split once, and not below rank 1");
  tree.cells[static_cast<std::size_t>(leaf)].child = first;
  Cell child = parent;
  child.child = -1;
  child.rank = static_cast<std::uint8_t>(parent.rank - 1);
  child.density = std::min(parent.density, static_cast<std::uint8_t>(3 * child.rank));
  const std::uint32_t side = 1u << (child.rank - 1);
  for (std::uint32_t k = 0; k < 4; ++k) {
    child.x = parent.x + (k & 1u) * side;
    child.y = parent.y + (k >> 1) * side;
    tree.cells.push_back(child);
  }
  return first;
}

namespace {

// Visits the leaves beside a leaf, some of them twice, until a visit returns true; returns that leaf, or -1.
template <class Visit>
std::int32_t firstNeighbour(const Quadtree& tree, std::int32_t leaf, LeafPath& path, const Visit& visit) {
  const Cell& cell = cellAt(tree, leaf);
  const std::uint32_t side = 1u << (cell.rank - 1);
  const std::uint32_t all = 1u << (cellAt(tree, 0).rank - 1);
  const std::int64_t left = static_cast<std::int64_t>(cell.x) - 1;
  const std::int64_t right = static_cast<std::int64_t>(cell.x) + side;
  const std::int64_t below = static_cast<std::int64_t>(cell.y) - 1;
  const std::int64_t above = static_cast<std::int64_t>(cell.y) + side;
  // Along each side, one step past the leaf just found.
  const auto along = [&](bool vertical, std::int64_t fixed) -> std::int32_t {
    if (fixed < 0 || fixed >= all) return -1;
    const auto line = static_cast<std::uint32_t>(fixed);
    const std::uint32_t from = vertical ? cell.y : cell.x;
    for (std::uint32_t s = from; s < from + side;) {
      const std::int32_t other = vertical ? leafOver(tree, line, s, path) : leafOver(tree, s, line, path);
      if (visit(other)) return other;
      const std::uint32_t step = 1u << (cellAt(tree, other).rank - 1);
      s = (s / step + 1) * step;
    }
    return -1;
  };
  std::int32_t found = along(false, below);
  if (found < 0) found = along(true, left);
  if (found < 0) found = along(true, right);
  if (found < 0) found = along(false, above);
  return found;
}

}  // namespace

void neighboursOf(const Quadtree& tree, std::int32_t leaf, LeafPath& path, std::vector<std::int32_t>& found) {
  found.clear();
  firstNeighbour(tree, leaf, path, [&](std::int32_t other) {
    if (std::find(found.begin(), found.end(), other) == found.end()) found.push_back(other);
    return false;
  });
}

void neighboursOf(const Quadtree& tree, std::int32_t leaf, std::vector<std::int32_t>& found) {
  LeafPath path;
  neighboursOf(tree, leaf, path, found);
}

std::int32_t unvisitedNeighbour(const Quadtree& tree, std::int32_t leaf, LeafPath& path) {
  return firstNeighbour(tree, leaf, path, [&](std::int32_t other) { return cellAt(tree, other).visited == 0; });
}

std::int32_t coarseNeighbour(const Quadtree& tree, std::int32_t leaf, LeafPath& path) {
  const int most = cellAt(tree, leaf).rank + 1;
  return firstNeighbour(tree, leaf, path, [&](std::int32_t other) { return cellAt(tree, other).rank > most; });
}

LatticeBox latticeBoxOf(const Quadtree& tree, const Box& box) {
  return {latticeOf(tree, box.lo.x - tree.origin.x), latticeOf(tree, box.lo.y - tree.origin.y),
          latticeOf(tree, box.hi.x - tree.origin.x), latticeOf(tree, box.hi.y - tree.origin.y)};
}

bool meets(const Cell& cell, const LatticeBox& box) {
  const std::uint32_t side = 1u << (cell.rank - 1);
  return cell.x <= box.x1 && cell.y <= box.y1 && box.x0 < cell.x + side && box.y0 < cell.y + side;
}

void leavesIn(const Quadtree& tree, const LatticeBox& box, std::vector<std::int32_t>& found) {
  found.clear();
  std::vector<std::int32_t> stack{0};
  while (!stack.empty()) {
    const std::int32_t index = stack.back();
    stack.pop_back();
    const Cell& cell = cellAt(tree, index);
    if (!meets(cell, box)) continue;
    if (cell.child < 0) found.push_back(index);
    for (std::int32_t k = 4; cell.child >= 0 && k-- > 0;) stack.push_back(cell.child + k);
  }
}

std::int32_t leafAt(const Quadtree& tree, Point p, LeafPath& path) {
  return leafOver(tree, latticeOf(tree, p.x - tree.origin.x), latticeOf(tree, p.y - tree.origin.y), path);
}

std::int32_t leafAt(const Quadtree& tree, Point p) {
  LeafPath path;
  return leafAt(tree, p, path);
}

int densityRankAt(const Quadtree& tree, Point p, LeafPath& path) { return cellAt(tree, leafAt(tree, p, path)).density; }
int densityRankAt(const Quadtree& tree, Point p) { return cellAt(tree, leafAt(tree, p)).density; }

double edgeLengthAt(const Quadtree& tree, Point p, LeafPath& path) {
  if (!tree.corners.empty()) return continuousLengthAt(tree, tree.corners, p, path);
  return edgeLengthOf(tree, densityRankAt(tree, p, path));
}
double edgeLengthAt(const Quadtree& tree, Point p) {
  LeafPath path;
  return edgeLengthAt(tree, p, path);
}

}  // namespace triscope
