// The boundary as short straight pieces in a bounding-box tree: what gaps and cells ask about.
#pragma once

#include <cstdint>
#include <vector>

#include "core/domain/domain.h"

namespace triscope {

/// A straight piece of a curve; the domain lies to its left (chains: on both sides).
struct BoundaryPiece {
  Point a, b;
  std::uint32_t curve = 0;
  bool twoSided = false;
};

struct BoundaryTree {
  struct Node {
    Box box;
    std::uint32_t first = 0;  // of its pieces in `pieces`, or of its two children in `nodes`
    std::uint32_t count = 0;  // 0 for an inner node
  };
  std::vector<BoundaryPiece> pieces;
  std::vector<Node> nodes;
};

/// Curved pieces are cut so that each turns by at most `turn` radians.
BoundaryTree boundaryTreeOf(const Domain& domain, double turn);

struct RayHit {
  double distance = 1e300;  // in lengths of the direction; 1e300 when nothing is hit
  std::uint32_t piece = 0;
};
/// First piece hit by origin + s·direction, s > 0. Curve `own`, where the ray starts, counts only when it is bent;
/// curves that share an end with it do not count.
RayHit castRay(const BoundaryTree& tree, const Domain& domain, Point origin, Point direction, std::uint32_t own);

/// Directions from `first`, turning clockwise by at most 180°, to `last`; both count.
struct Cone {
  Point apex, first, last;
};

struct Nearest {
  double distance = 1e300;  // 1e300 when the cone meets nothing
  Point at;
  std::uint32_t piece = 0;
};
/// Point of the boundary nearest to the apex of a cone, in the cone. Curves that end in the apex do not count.
Nearest nearestIn(const BoundaryTree& tree, const Domain& domain, const Cone& cone);

/// Even-odd rule by a horizontal ray; chains do not count.
bool insideDomain(const BoundaryTree& tree, Point p);

}  // namespace triscope
