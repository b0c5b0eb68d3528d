// The domain's outline as straight chords: what orientation and the checks are decided on. Lines are taken as they
// are; arcs and splines are sampled so that a chord turns by about one degree.
#pragma once

#include <cstdint>
#include <vector>

#include "core/domain/domain.h"

namespace triscope {

struct Chord {
  Point a;
  Point b;
  std::uint32_t loop = 0;
  std::uint32_t curve = 0;
  std::int32_t knot = 0;  // spline: index of the knot at or before a; 0 otherwise
  double t0 = 0.0;        // curve parameters of a and b
  double t1 = 1.0;
};

/// Parameters 0 … 1 of the points that stand for a curve, increasing; knots of a spline are among them.
std::vector<double> sampleParams(const Curve& curve);

/// The chords of a loop or chain, in order. None has length zero; a curve too small to have two different points
/// gives none.
std::vector<Chord> outlineOf(const Domain& domain, std::uint32_t loop);

}  // namespace triscope
