// What the density asks for at a place, for those who look at a state at any moment of the run: at its start there is
// no tree yet, and a cell that is selected may not have been made.
#pragma once

#include <cstdint>
#include <optional>

#include "core/density/quadtree.h"

namespace triscope {

struct Wanted {
  std::int32_t cell = -1;  // the leaf
  int rank = 1;            // density rank i
  double length = 0.0;     // edge length h in force: of the rank, or continuous
};

/// At p, or at the nearest place of the tree; nothing while there is no tree.
std::optional<Wanted> wantedAt(const Quadtree& tree, Point p);

/// The cell of this index; null while there is none.
const Cell* cellOf(const Quadtree& tree, std::int64_t index);

}  // namespace triscope
