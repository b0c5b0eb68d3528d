// The 2:1 balance of the quadtree, shared by the stages that split cells.
#pragma once

#include "core/method/pipeline.h"

namespace triscope {

/// Puts every leaf among the cells ahead.
void queueLeaves(MeshState& state);
/// Splits one leaf that is more than one rank larger than a neighbour among the cells ahead; `worked` when none was
/// found yet, done when there is none.
Outcome balanceOne(MeshState& state, Journal& journal);

}  // namespace triscope
