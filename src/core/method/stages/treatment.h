// The best that repair can do for one triangle, found by trying.
#pragma once

#include <array>

#include "core/method/stages/remedies.h"

namespace triscope {

/// One edit, or two of which only the second shows that the first was worth it.
using Treatment = std::array<Remedy, 2>;

/// The treatment that leaves the fewest broken bounds around the triangle, then the smallest excess, in the mesh's own
/// numbering; none when nothing makes it better. `floor` is what no edge may be shorter than: Δx, or where the input
/// itself is finer, its finest edge nearby.
Treatment bestTreatment(const MeshState& state, Slot slot, double& floor, Room& room);

}  // namespace triscope
