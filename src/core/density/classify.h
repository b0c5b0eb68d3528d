// Cell types (paper, section 2) and the estimate of the number of triangles (Table 1).
#pragma once

#include "core/density/quadtree.h"
#include "core/domain/domain.h"

namespace triscope {

/// Writes Cell::type of every leaf: boundary cells meet a boundary curve, adjacent ones touch a boundary cell from
/// inside, white ones are the other inner ones. Returns the estimated number of triangles: Table 1 per leaf, scaled
/// by the part of the leaf inside the domain (sampled 4 × 4 in boundary cells).
double classifyCells(Quadtree& tree, const Domain& domain);

}  // namespace triscope
