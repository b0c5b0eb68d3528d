// What brings every stage to an end where a rule alone would not: between curves that meet at small angles one split or
// insertion may call for the next. Limits grow with the input. Of the meshes of some two hundred domains, sharp ones
// among them, none came within a fifth of one, but for needles of a few triangles.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/method/state.h"

namespace triscope {

/// No edge is made shorter than this by a point put in: 2^-24 of what the density may ask for, and 2^-46 of the largest
/// coordinate, below which points on slanting lines are too coarse to stay in order.
double shortestMade(const MeshState& state);

/// Splits that recovery may make: 64 for each boundary point, and 1000. Halving an edge from Δx down to the shortest
/// takes 24, on either side of what is in its way. Most domains need none; hubs of dozens of chains one for every three
/// points.
std::uint64_t mostSplits(const MeshState& state);

/// Vertices at which steps 1-5 stop putting in more: eight times what the density foresees as triangles (Table 1) and
/// as boundary points, and 1000. Meshes have half as many vertices as triangles.
std::size_t mostVertices(const MeshState& state);

/// Decisions of repair in all rounds together: one for each triangle, and 1000.
std::uint64_t mostRepairs(const MeshState& state);

}  // namespace triscope
