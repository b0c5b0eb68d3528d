// What excuses a triangle from the bounds: an input angle that is too small.
#pragma once

#include <optional>

#include "core/mesh/mesh.h"

namespace triscope {

/// An angle of the domain in which a triangle lies.
struct InputAngle {
  Point at;
  double degrees = 0.0;
};

/// The smallest angle below 60° between two boundary edges (or borders of the mesh) at a corner of the triangle, with
/// the triangle between them: section 3 promises its bounds away from such angles.
std::optional<InputAngle> smallInputAngle(const Mesh& mesh, Slot slot);

}  // namespace triscope
