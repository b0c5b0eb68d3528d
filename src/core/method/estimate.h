// What a mesh will take, known before it is made: triangles by Table 1, and the memory for them.
#pragma once

#include <string>

#include "core/method/state.h"

namespace triscope {

struct Estimate {
  double triangles = 0.0;  // by Table 1, which may be half as much again as the mesh comes to; 0 while not known
  double bytes = 0.0;      // of memory at the peak of a run that writes the mesh and keeps no history
};
/// Of a state that the density stage is over in, or that has outgrown Settings::maxTriangles.
Estimate estimateOf(const MeshState& state);

/// "12 kB", "1.4 GB", "26 EB"
std::string bytesText(double bytes);
/// "940", "23.4 million", "2.1e+16": a number that is not known in all its digits.
std::string roughCount(double count);

}  // namespace triscope
