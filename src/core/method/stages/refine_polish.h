// Part 4 of step 6, our own: what is worst in the mesh, and the obtuse triangles, are polished by trying places around
// their vertices. Few triangles are such, so that this costs little, and lowers every worst figure.
#pragma once

#include "core/method/stages/refine_trial.h"

namespace triscope {

/// Before the passes near what is poor: takes the worst figures of the mesh, and settles the triangles that these
/// passes have nothing to say to.
void beginPolish(MeshState& state);

/// The next decision. Cursor::index = tries·place in the list of vertices + try.
Outcome runPolish(MeshState& state, Journal& journal, TrialRoom& room);

}  // namespace triscope
