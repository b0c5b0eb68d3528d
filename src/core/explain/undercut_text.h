// How the commands speak of a mesh that has an edge shorter than the smallest length that was given.
#pragma once

#include <string>

#include "core/method/state.h"
#include "core/quality/quality.h"

namespace triscope {

/// "the shortest edge, 0.0099 at (1, 2), is below the min_edge_length given, 1: it is a piece of 'hole 1'"; empty when
/// none is, and for a length that was derived. Such an edge comes of what the input fixes: kept edges that are shorter,
/// pieces of the boundary between kept points, gaps and sharp corners.
std::string undercutText(const MeshState& state, const Quality& quality);

}  // namespace triscope
