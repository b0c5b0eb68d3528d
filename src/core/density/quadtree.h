// The background quadtree that holds the density (paper, section 2, Table 1).
// Density rank i asks for the edge length Δx·2^((i-1)/3); cell rank j has side 4Δx·2^(j-1).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/point.h"

namespace triscope {

enum class CellType : std::uint8_t { outside, boundary, adjacent_boundary, white };

struct Cell {
  std::int32_t child = -1;  // first of four children (SW, SE, NW, NE), -1 for a leaf
  std::uint32_t x = 0;      // lower left corner in units of the rank-1 side
  std::uint32_t y = 0;
  std::uint8_t rank = 1;     // cell rank j
  std::uint8_t density = 1;  // density rank i
  CellType type = CellType::outside;
  std::uint8_t visited = 0;  // by the advancing front
};

/// Edge lengths at the corners of a cell: SW, SE, NW, NE.
using CornerLengths = std::array<float, 4>;

struct Quadtree {
  std::vector<Cell> cells;             // cells[0] is the root; none before the method has begun
  std::vector<CornerLengths> corners;  // by cell, once the edge length is made continuous; none where it goes by ranks
  Point origin;                        // lower left corner of the root
  double minEdge = 1.0;  // edge length of density rank 1, see finestLength(); known before there are cells
  double minEdgeInverse = 1.0;
  [[nodiscard]] double unit() const { return 4.0 * minEdge; }  // side of a rank-1 cell
  [[nodiscard]] double side(const Cell& c) const { return unit() * static_cast<double>(1ull << (c.rank - 1)); }
  [[nodiscard]] Point corner(const Cell& c) const {
    return {origin.x + unit() * static_cast<double>(c.x), origin.y + unit() * static_cast<double>(c.y)};
  }
};

/// Edge length of a density rank (>= 1) in units of Δx: 2^((rank-1)/3), exact at ranks 1, 4, 7, …
double rankLength(int densityRank);
/// Largest density rank whose edge length is <= length (in units of Δx); at least 1.
int rankAtMost(double lengthInMinEdges);
/// Edge length h of a density rank. Ranks are multiples of the tree's own length, which short input edges may have made
/// less than the Δx in force: whoever wants the length of a rank asks here.
double edgeLengthOf(const Quadtree& tree, int densityRank);
/// Smallest and largest cell rank that may hold a density rank (Table 1).
int smallestCellRank(int densityRank);
int largestCellRank(int densityRank);
/// Table 1, fifth column: 2 (side / h)².
double trianglesInCell(int cellRank, int densityRank);

/// A tree of one cell: the smallest square of side 4Δx·2^(j-1) that holds the box, centred on it. The box must not
/// be wider than kLargestSide·Δx.
inline constexpr double kLargestSide = 4.0 * (1u << 30);
Quadtree rootOver(const Box& box, double minEdge);

/// Gives a leaf four children that inherit its density as far as their rank allows. Returns the first.
std::int32_t splitCell(Quadtree& tree, std::int32_t leaf);

/// The way down to the leaf found last. Scratch that makes the search for a leaf nearby short: what is found does not
/// depend on it, whatever tree and place it comes from.
struct LeafPath {
  std::int32_t leaf = 0;
  std::uint32_t x = 0;  // lattice square that was searched for
  std::uint32_t y = 0;
  std::array<std::int32_t, 34> cells{};  // by rank
};

/// Leaves that share a side, or part of one, with the leaf, each once, in a fixed order.
void neighboursOf(const Quadtree& tree, std::int32_t leaf, LeafPath& path, std::vector<std::int32_t>& found);
void neighboursOf(const Quadtree& tree, std::int32_t leaf, std::vector<std::int32_t>& found);
/// The first of them that the advancing front has not visited, or that is coarser by more than a rank; -1 when none is.
std::int32_t unvisitedNeighbour(const Quadtree& tree, std::int32_t leaf, LeafPath& path);
std::int32_t coarseNeighbour(const Quadtree& tree, std::int32_t leaf, LeafPath& path);

/// Squares of rank-1 side from (x0, y0) to (x1, y1), both counted in.
struct LatticeBox {
  std::uint32_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};
/// Those that hold a point of the box; what lies outside the root counts as its nearest square.
LatticeBox latticeBoxOf(const Quadtree& tree, const Box& box);
/// Whether a cell has one of them.
bool meets(const Cell& cell, const LatticeBox& box);

/// Leaves that have one of them, in the order of the tree.
void leavesIn(const Quadtree& tree, const LatticeBox& box, std::vector<std::int32_t>& found);

/// Leaf over a square of rank-1 side, counted from the root's corner; it must lie in the root.
std::int32_t leafOver(const Quadtree& tree, std::uint32_t x, std::uint32_t y, LeafPath& path);
/// Leaf that holds p (points outside the root go to the nearest leaf).
std::int32_t leafAt(const Quadtree& tree, Point p, LeafPath& path);
std::int32_t leafAt(const Quadtree& tree, Point p);
/// Density rank at p, and edge length: that of the rank, or the continuous one where the tree has it.
int densityRankAt(const Quadtree& tree, Point p, LeafPath& path);
int densityRankAt(const Quadtree& tree, Point p);
double edgeLengthAt(const Quadtree& tree, Point p, LeafPath& path);
double edgeLengthAt(const Quadtree& tree, Point p);

}  // namespace triscope
