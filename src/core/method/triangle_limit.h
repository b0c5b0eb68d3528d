// What is said of a run that stops because the mesh would have more triangles than Settings::maxTriangles.
#pragma once

#include <string>

#include "core/base/result.h"
#include "core/method/state.h"
#include "core/words/event.h"

namespace triscope {

/// Whether that is why the run stopped.
bool overLimit(const MeshState& state);

/// The wish or setting that takes the most triangles.
struct Asker {
  Rule source = Rule::none;     // none: the setting max_rank
  std::uint32_t curve = kNoId;  // as in Constraint
  double length = 0.0;          // edge length asked for
  Point at;
  std::string name;  // "density entry 'wake'", "the curvature of loop 'hole 1'", "the setting max_rank"
};
Asker askerOf(const MeshState& state);

/// How many triangles and bytes it would take, what asks for them, and what to change.
Error tooManyTriangles(const MeshState& state);

}  // namespace triscope
