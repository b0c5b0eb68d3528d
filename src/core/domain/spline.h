// Smooth curves through given points: cubic splines with continuous curvature, parametrised by chord length
// (C. de Boor, "A Practical Guide to Splines", 1978).
#pragma once

#include <vector>

#include "core/domain/curve.h"

namespace triscope {

/// Neighbouring points closer than this fraction of the whole polyline leave too few digits for a spline.
inline constexpr double kShortestSpan = 1e-9;

/// Index of the first of two neighbouring points that are too close for a spline, -1 when there are none.
int tooCloseForSpline(const std::vector<Point>& points);

/// An open curve through two or more points, none too close. The second derivative is constant over the first and
/// the last span, so three points give a parabola; two give a line.
Curve makeSpline(std::vector<Point> points);

/// A closed curve, smooth everywhere, that starts and ends at points[0]. Three or more points, the first not
/// repeated at the end, no neighbours too close.
Curve makeClosedSpline(std::vector<Point> points);

}  // namespace triscope
