// What the optimiser could not reach, and what stands in the way.
#pragma once

#include <string>
#include <vector>

#include "core/method/state.h"
#include "core/quality/quality.h"

namespace triscope {

/// A line for each aim that an optimised mesh does not keep to: "smallest angle 41.2, not 44, at (0.1, 2) beside
/// 'hole 1'". Nothing where none is, where a bound of the paper is not kept either, or the mesh was not
/// optimised.
std::vector<std::string> unmetAimTexts(const MeshState& state, const Quality& quality);

/// Where the obtuse triangles of a finished mesh are: "8 obtuse triangles: 5 at the input angle of 18.4° at (3.2, 2),
/// 3 at …". The places with most come first, and five of them are named. Empty where there is no such triangle.
std::string obtuseText(const MeshState& state, const Quality& quality);

}  // namespace triscope
