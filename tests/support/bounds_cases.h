// The promise of the method on one domain: run it, with and without step 6, and hold the mesh to its bounds.
#pragma once

#include <filesystem>
#include <ostream>

#include "core/method/state.h"

namespace triscope::support {

struct BoundsCase {
  std::filesystem::path file;
  double minEdge = 0.0;  // Δx; 0: the file's, or derived
};
void PrintTo(const BoundsCase& bounds, std::ostream* out);

/// The mesh of steps 1-5 meets every bound, and so does that of step 6, with less than 1 % obtuse. Returns it.
MeshState expectPromise(const BoundsCase& bounds);

}  // namespace triscope::support
