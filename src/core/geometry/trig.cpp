#include "core/geometry/trig.h"

#include <array>
#include <cmath>

namespace triscope::trig {

namespace {

// pi/2 in three parts. The first two have 33 bits each, so that their products with a count of quarter turns
// below 2^20 are exact and the reduced angle keeps its relative accuracy near multiples of pi/2.
constexpr double kHalfPi1 = 0x1.921fb544p+0;
constexpr double kHalfPi2 = 0x1.0b4611a6p-34;
constexpr double kHalfPi3 = 0x1.3198a2e037073p-69;
constexpr double kHalfPiLow = 6.123233995736766e-17;  // pi/2 - double(pi/2)

// Taylor series on [-pi/4, pi/4]: the first term left out is below 1e-19 of the value.
double sineSeries(double x) {
  const double z = x * x;
  double sum = 1.0 / 355687428096000.0;  // 17!
  sum = -1.0 / 1307674368000.0 + z * sum;
  sum = 1.0 / 6227020800.0 + z * sum;
  sum = -1.0 / 39916800.0 + z * sum;
  sum = 1.0 / 362880.0 + z * sum;
  sum = -1.0 / 5040.0 + z * sum;
  sum = 1.0 / 120.0 + z * sum;
  sum = -1.0 / 6.0 + z * sum;
  return x + x * (z * sum);
}

double cosineSeries(double x) {
  const double z = x * x;
  double sum = -1.0 / 6402373705728000.0;  // 18!
  sum = 1.0 / 20922789888000.0 + z * sum;
  sum = -1.0 / 87178291200.0 + z * sum;
  sum = 1.0 / 479001600.0 + z * sum;
  sum = -1.0 / 3628800.0 + z * sum;
  sum = 1.0 / 40320.0 + z * sum;
  sum = -1.0 / 720.0 + z * sum;
  sum = 1.0 / 24.0 + z * sum;
  // 1 - z/2 loses its low bits; give them back.
  const double half = 0.5 * z;
  const double head = 1.0 - half;
  return head + ((1.0 - head - half) + z * z * sum);
}

struct Node {
  double high;
  double low;
};

// atan(k/8) as a sum of two doubles.
constexpr std::array<Node, 9> kArcTangents{{{0.0, 0.0},
                                            {0.12435499454676144, -3.1253241424539383e-18},
                                            {0.24497866312686414, 1.0698755618734451e-17},
                                            {0.35877067027057225, -2.4623815582638635e-17},
                                            {0.4636476090008061, 2.2698777452961687e-17},
                                            {0.5585993153435624, -5.4556305485916264e-18},
                                            {0.6435011087932844, 1.5834785051444286e-17},
                                            {0.7188299996216245, -2.1478388444456983e-17},
                                            {0.7853981633974483, 3.061616997868383e-17}}};

/// atan(y/x) for 0 <= y <= x, x > 0: the nearest atan(k/8) plus a short series.
double arcTangent(double y, double x) {
  const double k = std::floor(8.0 * (y / x) + 0.5);
  const double c = 0.125 * k;
  const double u = (y - c * x) / (x + c * y);  // |u| <= 1/16
  const double z = u * u;
  double sum = 1.0 / 13.0;
  sum = -1.0 / 11.0 + z * sum;
  sum = 1.0 / 9.0 + z * sum;
  sum = -1.0 / 7.0 + z * sum;
  sum = 1.0 / 5.0 + z * sum;
  sum = -1.0 / 3.0 + z * sum;
  const Node node = kArcTangents[static_cast<std::size_t>(k)];
  return node.high + (u + (node.low + u * (z * sum)));
}

}  // namespace

SinCos sinCos(double radians) {
  const double turns = std::floor(radians * (2.0 / kPi) + 0.5);
  const double head = (radians - turns * kHalfPi1) - turns * kHalfPi2;
  const double reduced = head - turns * kHalfPi3;
  const double s = sineSeries(reduced);
  const double c = cosineSeries(reduced);
  switch (static_cast<int>(turns - 4.0 * std::floor(0.25 * turns))) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

double atan2(double y, double x) {
  const double ay = std::fabs(y);
  const double ax = std::fabs(x);
  if (ax == 0.0 && ay == 0.0) return 0.0;
  double angle = ay <= ax ? arcTangent(ay, ax) : (0.5 * kPi - arcTangent(ax, ay)) + kHalfPiLow;
  if (x < 0.0) angle = (kPi - angle) + 2.0 * kHalfPiLow;
  return y < 0.0 ? -angle : angle;
}

}  // namespace triscope::trig
