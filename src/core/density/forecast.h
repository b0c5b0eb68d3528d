// What a quadtree that still grows will come to: wishes known beforehand are taken as granted wherever they hold.
#pragma once

#include "core/density/quadtree.h"
#include "core/domain/domain.h"
#include "core/settings.h"

namespace triscope {

/// The tree with the ranks that its leaves end with at most: those that boxes of the domain and `max_rank` ask for
/// among them. `minEdge` is Δx.
Quadtree forecastOf(const Quadtree& tree, const Domain& domain, const Settings& settings, double minEdge);

/// Triangles by Table 1 of all leaves, those outside the domain too: quickly known, and never too few.
double trianglesInTree(const Quadtree& tree);

}  // namespace triscope
