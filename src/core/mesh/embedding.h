// Do parts of a mesh lie over one another? Triangles that run counter-clockwise and share edges two by two can still
// cover a place twice: a strip that winds about itself, two pieces one on the other. The borders tell: a mesh whose
// borders neither meet nor lie inside one another wrongly covers every place once (each place is covered as often as
// the borders wind about it).
#pragma once

#include <optional>

#include "core/mesh/validate.h"

namespace triscope {

/// The first place where borders cross, touch or nest wrongly: a border that runs round a part must lie outside all
/// others or in a hole, the border of a hole inside a part. Needs a mesh that is sound otherwise: linked,
/// counter-clockwise, one fan about each vertex. O(n log n) in the number of border edges; exact.
std::optional<Violation> findOverlap(const Mesh& mesh);

}  // namespace triscope
