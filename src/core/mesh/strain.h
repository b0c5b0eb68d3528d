// How near the triangles of a region come to the worst of the whole mesh, in every measure at once.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/mesh/badness.h"

namespace triscope {

/// Worst figures of the mesh, or the bounds of section 3 where the input forces worse ones.
struct Worst {
  double aspect = 2.0;  // R/r; these are the figures of an equilateral triangle among equals
  double areaRatio = 1.0;
  double edgeRatio = 1.0;
  double radius = 0.57735026918962573;  // R/e
};

inline void include(Worst& worst, const Badness& region) {
  worst.aspect = std::clamp(region.worst, worst.aspect, 4.31);
  worst.areaRatio = std::clamp(region.areaRatio, worst.areaRatio, 3.0);
  worst.edgeRatio = std::clamp(std::sqrt(region.edgeRatio), worst.edgeRatio, 2.0);
  worst.radius = std::clamp(std::sqrt(region.radius), worst.radius, 1.0);
}

/// 1 for the worst triangle of the mesh in some measure, 0 for equilateral ones of one size.
inline double strainOf(const Badness& region, const Worst& worst) {
  constexpr Worst best;
  const auto part = [](double is, double least, double most) {
    return most > least ? (is - least) / (most - least) : 0.0;
  };
  return std::max({part(region.worst, best.aspect, worst.aspect),
                   part(region.areaRatio, best.areaRatio, worst.areaRatio),
                   part(std::sqrt(region.edgeRatio), best.edgeRatio, worst.edgeRatio),
                   part(std::sqrt(region.radius), best.radius, worst.radius)});
}

}  // namespace triscope
