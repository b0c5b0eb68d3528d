// The edge length in force at each vertex: what those who place rows of points, or move vertices, hold edges against.
#pragma once

#include "core/method/state.h"

namespace triscope {

/// Gives every vertex that has none yet the length that is wanted where it stands: of the corners' bilinear lengths, or
/// of its cell's rank where `corners` is empty. On the boundary the edges that are there count, wholly where they are
/// shorter than that, half where they are longer: what the input fixes so fades out from row to row.
void extendSizes(MeshState& state, const std::vector<CornerLengths>& corners);

/// Makes the lengths inside the domain those that the mesh has there on the whole: one ratio for all, by area, so that
/// no edge looks short or long for the mean length alone, which is up to 1.25 times what is wanted where circumcentres
/// were taken.
void fitSizes(MeshState& state);

}  // namespace triscope
