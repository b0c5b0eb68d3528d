// The edge length made continuous: ranks jump by 26 % from a cell to the next, and a mesh that is to be as regular as
// can be shows each jump as a row of defects.
#pragma once

#include <vector>

#include "core/density/quadtree.h"

namespace triscope {

/// Edge lengths at the corners of each cell, of leaves only; what lies between is bilinear. Twice each leaf's length
/// goes half of the way to the mean of its neighbours'; a corner then has the mean of the leaves around it, and one in
/// the middle of a larger leaf's side the mean of the side's ends, so that both sides agree. No length leaves the range
/// of the ranks' lengths. O(leaves). The tree is one whose ranks are final.
std::vector<CornerLengths> continuousLengths(const Quadtree& tree);

/// The edge length at p that corner lengths of the tree's own cells give; points outside the root have that of the
/// nearest on its border.
double continuousLengthAt(const Quadtree& tree, const std::vector<CornerLengths>& corners, Point p, LeafPath& path);

}  // namespace triscope
