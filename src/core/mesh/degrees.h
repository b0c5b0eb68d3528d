// Which vertices have more or fewer triangles than equilateral ones would give them.
#pragma once

#include "core/mesh/mesh.h"

namespace triscope {

/// Per vertex, how many triangles it has beyond six; on a boundary, beyond the number of sixths of a turn that the
/// angle of the domain there is nearest to, one at least, either of two that it is half-way between. 0 for a vertex
/// that no triangle uses. O(n). For a mesh without the box around everything.
Per<Vertex, std::int8_t> degreeExcess(const Mesh& mesh);

}  // namespace triscope
