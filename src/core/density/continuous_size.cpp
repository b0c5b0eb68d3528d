#include "core/density/continuous_size.h"

#include <algorithm>

namespace triscope {
namespace {

constexpr int kSmoothings = 2;

const Cell& cellOf(const Quadtree& tree, std::size_t index) { return tree.cells[index]; }

// By cell; of leaves only.
std::vector<double> smoothedLengths(const Quadtree& tree) {
  const std::size_t count = tree.cells.size();
  std::vector<double> lengths(count, 0.0);
  for (std::size_t k = 0; k < count; ++k) lengths[k] = edgeLengthOf(tree, cellOf(tree, k).density);
  LeafPath path;
  std::vector<std::int32_t> beside;
  for (int turn = 0; turn < kSmoothings; ++turn) {
    std::vector<double> next = lengths;
    for (std::size_t k = 0; k < count; ++k) {
      if (cellOf(tree, k).child >= 0) continue;
      neighboursOf(tree, static_cast<std::int32_t>(k), path, beside);
      double sum = 0.0;
      for (const std::int32_t other : beside) sum += lengths[static_cast<std::size_t>(other)];
      if (!beside.empty()) next[k] = 0.5 * lengths[k] + 0.5 * sum / static_cast<double>(beside.size());
    }
    lengths.swap(next);
  }
  return lengths;
}

struct CornerSearch {
  const Quadtree& tree;
  const std::vector<double>& lengths;  // by cell
  std::int64_t all;                    // squares of rank-1 side along the root
  LeafPath path;

  // At a corner of the lattice of rank-1 squares that is the corner of some leaf. The leaf whose side it lies in the
  // middle of is larger than that one, so the search from side to side ends.
  double at(std::int64_t x, std::int64_t y) {
    double sum = 0.0;
    int count = 0;
    for (int quarter = 0; quarter < 4; ++quarter) {
      const std::int64_t squareX = x - (quarter & 1), squareY = y - (quarter >> 1);
      if (squareX < 0 || squareY < 0 || squareX >= all || squareY >= all) continue;
      const std::int32_t leaf =
          leafOver(tree, static_cast<std::uint32_t>(squareX), static_cast<std::uint32_t>(squareY), path);
      const Cell& cell = cellOf(tree, static_cast<std::size_t>(leaf));
      const std::int64_t side = std::int64_t{1} << (cell.rank - 1);
      const std::int64_t left = cell.x, below = cell.y;
      const bool onVertical = x == left || x == left + side, onHorizontal = y == below || y == below + side;
      if (onVertical && !onHorizontal) return 0.5 * (at(x, below) + at(x, below + side));
      if (!onVertical) return 0.5 * (at(left, y) + at(left + side, y));
      sum += lengths[static_cast<std::size_t>(leaf)];
      ++count;
    }
    return sum / count;
  }
};

}  // namespace

std::vector<CornerLengths> continuousLengths(const Quadtree& tree) {
  const std::vector<double> lengths = smoothedLengths(tree);
  CornerSearch search{tree, lengths, std::int64_t{1} << (cellOf(tree, 0).rank - 1), {}};
  std::vector<CornerLengths> corners(tree.cells.size(), CornerLengths{});
  for (std::size_t k = 0; k < tree.cells.size(); ++k) {
    const Cell& cell = cellOf(tree, k);
    if (cell.child >= 0) continue;
    const std::int64_t side = std::int64_t{1} << (cell.rank - 1);
    for (std::size_t corner = 0; corner < 4; ++corner) {
      const std::int64_t x = corner % 2 == 0 ? 0 : side, y = corner < 2 ? 0 : side;
      corners[k][corner] = static_cast<float>(search.at(cell.x + x, cell.y + y));
    }
  }
  return corners;
}

double continuousLengthAt(const Quadtree& tree, const std::vector<CornerLengths>& corners, Point p, LeafPath& path) {
  const auto leaf = static_cast<std::size_t>(leafAt(tree, p, path));
  const Cell& cell = cellOf(tree, leaf);
  const double scale = 0.25 * tree.minEdgeInverse / static_cast<double>(1ull << (cell.rank - 1));
  const Point low = tree.corner(cell);
  const double u = std::clamp((p.x - low.x) * scale, 0.0, 1.0), v = std::clamp((p.y - low.y) * scale, 0.0, 1.0);
  const CornerLengths& at = corners[leaf];
  const double below = (1.0 - u) * static_cast<double>(at[0]) + u * static_cast<double>(at[1]);
  const double above = (1.0 - u) * static_cast<double>(at[2]) + u * static_cast<double>(at[3]);
  return (1.0 - v) * below + v * above;
}

}  // namespace triscope
