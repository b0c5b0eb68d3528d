// The middle of a triangle.
#pragma once

#include "core/mesh/mesh.h"

namespace triscope {

inline Point centroidOf(const Mesh& mesh, Slot slot) {
  const Triangle& t = triangleAt(mesh, slot);
  return (1.0 / 3.0) * (pointOf(mesh, t.v[0]) + pointOf(mesh, t.v[1]) + pointOf(mesh, t.v[2]));
}

}  // namespace triscope
