// One smooth piece of a boundary between two kept points: a straight line, a circular arc or a spline run.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/point.h"

namespace triscope {

enum class CurveKind : std::uint8_t { line, arc, spline };

/// Parametrised over t in [0, 1]. The ends are exact: pointAt(c, 0) == c.a and pointAt(c, 1) == c.b.
struct Curve {
  CurveKind kind = CurveKind::line;
  Point a{};                     // first end, shared bit for bit with the previous curve's b
  Point b{};                     // last end (a full circle has a == b)
  Point centre{};                // arc
  double radius = 0.0;           // arc
  double startAngle = 0.0;       // arc, radians
  double sweptAngle = 0.0;       // arc, radians, positive counter-clockwise
  std::vector<Point> knots{};    // spline: the input points from a to b
  std::vector<Point> slopes{};   // spline: derivative at each knot w.r.t. the knot parameter below
  std::vector<double> params{};  // spline: increasing, params.front() == 0, params.back() == 1
};

Point pointAt(const Curve& curve, double t);
/// Derivative with respect to t; its length is the speed ds/dt.
Point derivativeAt(const Curve& curve, double t);
/// Curvature 1/radius, >= 0; 0 on a line.
double curvatureAt(const Curve& curve, double t);
/// Arc length between two parameters t0 <= t1 (Gauss-Legendre on spline spans).
double lengthBetween(const Curve& curve, double t0, double t1);

}  // namespace triscope
