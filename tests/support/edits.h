// One random edit of a mesh in its domain.
#pragma once

#include <string>

#include "core/mesh/edit.h"
#include "core/method/stages/place.h"
#include "core/method/state.h"
#include "support/random.h"

namespace triscope::support {

struct EditCounts {
  int inserted = 0;
  int moved = 0;
  int removed = 0;
  int split = 0;
};

/// Inserts a point, moves or removes a vertex, or splits a boundary edge, as the generator says; counts what was not
/// refused, and says in words what was tried.
std::string editAtRandom(MeshState& state, Random& random, EditCounts& counts);

}  // namespace triscope::support
