// Trigonometry from + - * / and sqrt only: the same bits from every compiler and every C library.
// Everything that reaches the mesh uses these and never the functions of <cmath>.
#pragma once

#include "core/base/point.h"

namespace triscope::trig {

inline constexpr double kPi = 3.141592653589793;
inline constexpr double kDegree = kPi / 180.0;  // radians in one degree

struct SinCos {
  double sin = 0.0;
  double cos = 1.0;
};

/// Sine and cosine of an angle in radians, |angle| <= 1e6. Relative error below 4e-16 (two units in the last place).
SinCos sinCos(double radians);
inline double sin(double radians) { return sinCos(radians).sin; }
inline double cos(double radians) { return sinCos(radians).cos; }

/// Angle of the vector (x, y) in radians, in (-pi, pi]; 0 for the zero vector. Relative error below 4e-16.
double atan2(double y, double x);

/// Angle from a to b in radians, in (-pi, pi], positive counter-clockwise; 0 when either is zero.
inline double angleBetween(Point a, Point b) { return trig::atan2(cross(a, b), dot(a, b)); }

}  // namespace triscope::trig
