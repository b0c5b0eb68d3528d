// What differs between two meshes of one run: a look at two moments of it costs as much as to copy one.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/mesh/mesh.h"

namespace triscope {

/// Slots of `after` that hold another triangle than in `before`, other links or flags, or a triangle with a corner that
/// has been moved; in any order, and some of them twice. Nothing when there are more than `most`, or about so many.
std::optional<std::vector<Slot>> changedSlots(const Mesh& before, const Mesh& after, std::size_t most);

}  // namespace triscope
