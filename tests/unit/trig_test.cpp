#include "core/geometry/trig.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>

namespace triscope::trig_test {
namespace {

constexpr double kAccuracy = 4e-16;

double relativeError(double value, long double exact) {
  return static_cast<double>(std::fabs((value - exact) / exact));
}

/// Angles and ratios over twelve orders of magnitude.
double sample(std::mt19937_64& random) {
  const double unit = static_cast<double>(random() >> 11) * 0x1p-53;
  const double scale = std::ldexp(1.0, -static_cast<int>(random() % 40));
  return (2.0 * unit - 1.0) * 40.0 * scale;
}

TEST(Trig, SineAndCosineAreAccurate) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 200000; ++i) {
    const double angle = sample(random);
    if (angle == 0.0) continue;
    const trig::SinCos result = trig::sinCos(angle);
    ASSERT_LT(relativeError(result.sin, std::sin(static_cast<long double>(angle))), kAccuracy) << angle;
    ASSERT_LT(relativeError(result.cos, std::cos(static_cast<long double>(angle))), kAccuracy) << angle;
  }
}

TEST(Trig, AccuracyHoldsNextToMultiplesOfHalfPi) {
  for (int turns = -2000; turns <= 2000; ++turns) {
    double angle = 0.5 * trig::kPi * turns;
    for (int step = 0; step < 3; ++step, angle = std::nextafter(angle, 1e9)) {
      if (angle == 0.0) continue;
      const trig::SinCos result = trig::sinCos(angle);
      // The oracle itself keeps 64 bits, so that near a zero it is worth an absolute 1e-19 of the angle.
      const auto exact = static_cast<long double>(angle);
      ASSERT_NEAR(result.sin, static_cast<double>(std::sin(exact)), 2e-16 * std::fabs(result.sin) + 1e-22);
      ASSERT_NEAR(result.cos, static_cast<double>(std::cos(exact)), 2e-16 * std::fabs(result.cos) + 1e-22);
    }
  }
}

TEST(Trig, QuarterTurnsAreWhereTheyBelong) {
  EXPECT_EQ(trig::sin(0.0), 0.0);
  EXPECT_EQ(trig::cos(0.0), 1.0);
  EXPECT_EQ(trig::sin(0.5 * trig::kPi), 1.0);
  EXPECT_EQ(trig::cos(trig::kPi), -1.0);
  EXPECT_EQ(trig::sin(1.5 * trig::kPi), -1.0);
  EXPECT_EQ(trig::sin(-0.3), -trig::sin(0.3));
  EXPECT_EQ(trig::cos(-0.3), trig::cos(0.3));
}

TEST(Trig, ArcTangentIsAccurateInEveryQuadrant) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 200000; ++i) {
    const double y = sample(random);
    const double x = sample(random);
    if (x == 0.0 || y == 0.0) continue;
    const long double exact = std::atan2(static_cast<long double>(y), static_cast<long double>(x));
    ASSERT_LT(relativeError(trig::atan2(y, x), exact), kAccuracy) << y << " " << x;
  }
}

TEST(Trig, ArcTangentOnTheAxes) {
  EXPECT_EQ(trig::atan2(0.0, 0.0), 0.0);
  EXPECT_EQ(trig::atan2(0.0, 2.0), 0.0);
  EXPECT_EQ(trig::atan2(2.0, 0.0), 0.5 * trig::kPi);
  EXPECT_EQ(trig::atan2(0.0, -2.0), trig::kPi);
  EXPECT_EQ(trig::atan2(-2.0, 0.0), -0.5 * trig::kPi);
  EXPECT_EQ(trig::atan2(3.0, 3.0), 0.25 * trig::kPi);
}

TEST(Trig, AngleBetweenIsPositiveCounterClockwise) {
  EXPECT_DOUBLE_EQ(trig::angleBetween({1, 0}, {0, 2}), 0.5 * trig::kPi);
  EXPECT_DOUBLE_EQ(trig::angleBetween({0, 2}, {1, 0}), -0.5 * trig::kPi);
  EXPECT_DOUBLE_EQ(trig::angleBetween({1, 1}, {-1, 1}), 0.5 * trig::kPi);
}

/// The same bits from every compiler and optimisation level: the digest was recorded once.
TEST(Trig, BitsAreTheSameEverywhere) {
  std::uint64_t digest = 0xcbf29ce484222325u;
  const auto mix = [&](double value) { digest = (digest ^ std::bit_cast<std::uint64_t>(value)) * 0x100000001b3u; };
  std::mt19937_64 random(3);
  for (int i = 0; i < 20000; ++i) {
    const double a = sample(random);
    const double b = sample(random);
    mix(trig::sin(a));
    mix(trig::cos(a));
    mix(trig::atan2(a, b));
  }
  EXPECT_EQ(digest, 863904029047791782u);
}

}  // namespace
}  // namespace triscope::trig_test
