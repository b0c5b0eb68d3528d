// What a quadtree that still grows will come to: wishes known beforehand are taken as granted wherever they hold.
#pragma once

#include <cstdint>
#include <vector>

#include "core/density/quadtree.h"
#include "core/domain/domain.h"
#include "core/words/settings.h"

namespace triscope {

/// The density rank that each cell of the tree ends with at most: those that boxes of the domain and `max_rank` ask
/// for among them. 0 where a cell is no leaf. `minEdge` is Δx.
std::vector<std::uint8_t> forecastOf(const Quadtree& tree, const Domain& domain, const Settings& settings,
                                     double minEdge);

/// Triangles by Table 1 of all leaves with these ranks, those outside the domain too: quickly known, and never too few.
double trianglesInTree(const Quadtree& tree, const std::vector<std::uint8_t>& ranks);

}  // namespace triscope
