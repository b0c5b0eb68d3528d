// Random domains without an input angle below 60°, as texts that the program can read too.
#pragma once

#include <string>

#include "core/base/point.h"
#include "support/random.h"

namespace triscope::support {

/// How a domain made about the origin, a few units across, is put in the plane.
struct SizeAndPlace {
  double scale = 1.0;
  Point by;  // after scaling
};

enum class Shape : std::uint8_t { star, round, perforated, cracked };
inline constexpr int kShapes = 4;

/// star: a polygon around a point, corners of 62° or more. round: a circle with up to three circular holes, some near
/// each other. perforated: a box with circles and regular polygons in it. cracked: a star with open chains in it.
std::string randomDomain(Random& random, Shape shape, const SizeAndPlace& placement);

/// Scales from 1e-9 to 4e7 about the origin, and unit scale far from it.
SizeAndPlace randomSizeAndPlace(Random& random);

}  // namespace triscope::support
