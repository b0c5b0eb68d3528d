// The last part of the optimiser: edits around each triangle that is beyond the aims still.
#pragma once

#include "core/method/stages/optimise_parts.h"

namespace triscope {

void beginCure(Optimiser& o);
void beginCurePairs(Optimiser& o);
/// One edit tried, and kept when nothing in the patch is beyond the aims any more; in the end the best of them, when
/// the penalty of the patch falls by a fifth.
Outcome runCure(Optimiser& o);
/// Two edits in a row, the second around what is worst after the first: for the few that no single edit cures.
Outcome runCurePairs(Optimiser& o);

}  // namespace triscope
