// Is a mesh one of this domain?
#pragma once

#include <vector>

#include "core/domain/domain.h"
#include "core/mesh/validate.h"

namespace triscope {

/// What is wrong, as Broken::domain, at most `limit` of it; empty when nothing is:
/// - every end of a curve is a vertex, bit for bit;
/// - every straight piece runs along edges of the mesh, whose vertices lie on it within 1e-12 of the domain's size;
/// - the mesh ends nowhere but there: a border vertex lies on some boundary (checked where all pieces are straight);
/// - the area is the polygon's to 1e-12 of it (where all pieces are straight; the polygon's is summed exactly).
std::vector<Violation> checkAgainstDomain(const Mesh& mesh, const Domain& domain, std::size_t limit = 20);

}  // namespace triscope
