// MeshState::boundary names the point between two curves twice, once for each; here it is named once.
#pragma once

#include <vector>

#include "core/method/state.h"

namespace triscope {

/// Indices into MeshState::boundary, each place once.
std::vector<std::size_t> distinctBoundaryPoints(const MeshState& state);

}  // namespace triscope
