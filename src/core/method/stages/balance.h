// The 2:1 balance of the quadtree, shared by the stages that split cells.
#pragma once

#include "core/method/pipeline.h"

namespace triscope {

/// Puts every leaf on the cursor's worklist.
void queueLeaves(MeshState& state);
/// Splits one leaf that is more than one rank larger than a neighbour on the worklist; `worked` when none was found
/// yet, done when there is none.
Outcome balanceOne(MeshState& state, Journal& journal);

}  // namespace triscope
