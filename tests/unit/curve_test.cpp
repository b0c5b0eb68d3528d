#include "core/domain/curve.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/domain/arc.h"
#include "core/domain/orient.h"
#include "core/domain/spline.h"
#include "core/geometry/trig.h"

namespace triscope::curve_test {
namespace {

Curve line(Point a, Point b) { return {.kind = CurveKind::line, .a = a, .b = b}; }

std::vector<Point> ellipse(int count, double width, double height) {
  std::vector<Point> points;
  for (int i = 0; i < count; ++i) {
    const trig::SinCos direction = trig::sinCos(2.0 * trig::kPi * i / count);
    points.push_back({width * direction.cos, height * direction.sin});
  }
  return points;
}

Curve wave() { return makeSpline({{0, 0}, {1, 0.7}, {1.8, 0.2}, {3, -0.4}, {3.3, 0.5}, {4, 1}}); }

std::vector<Curve> oneOfEach() {
  return {line({0.1, 0.2}, {3.3, -1.7}), *arcThrough({0.1, 0.7}, {1.3, 1.9}, {2.1, 0.3}), makeCircle({0.3, 0.1}, 1.7),
          wave(), makeClosedSpline(ellipse(12, 3, 1))};
}

TEST(Curve, EndsAreExact) {
  for (const Curve& curve : oneOfEach()) {
    EXPECT_EQ(pointAt(curve, 0.0), curve.a);
    EXPECT_EQ(pointAt(curve, 1.0), curve.b);
    EXPECT_LT(distance(pointAt(curve, 1e-13), curve.a), 1e-11);
    EXPECT_LT(distance(pointAt(curve, 1.0 - 1e-13), curve.b), 1e-11);
  }
}

TEST(Curve, DerivativeIsTheLimitOfDifferences) {
  for (const Curve& curve : oneOfEach()) {
    for (double t = 0.05; t < 1.0; t += 0.0901) {
      const double step = 1e-6;
      const Point difference = (0.5 / step) * (pointAt(curve, t + step) - pointAt(curve, t - step));
      EXPECT_LT(distance(difference, derivativeAt(curve, t)), 1e-5 * (1.0 + length(difference)));
    }
  }
}

TEST(Curve, CurvatureIsTheTurningOfTheTangent) {
  for (const Curve& curve : oneOfEach()) {
    for (double t = 0.05; t < 1.0; t += 0.0901) {
      const double step = 1e-5;
      const Point before = derivativeAt(curve, t - step);
      const Point after = derivativeAt(curve, t + step);
      const double turn = std::fabs(trig::angleBetween(before, after));
      EXPECT_NEAR(curvatureAt(curve, t), turn / lengthBetween(curve, t - step, t + step), 2e-4);
    }
  }
}

TEST(Curve, LengthOfLineAndArcIsClosedForm) {
  EXPECT_DOUBLE_EQ(lengthBetween(line({1, 1}, {4, 5}), 0.0, 1.0), 5.0);
  EXPECT_DOUBLE_EQ(lengthBetween(line({1, 1}, {4, 5}), 0.25, 0.75), 2.5);
  EXPECT_DOUBLE_EQ(lengthBetween(makeCircle({3, 4}, 2), 0.0, 1.0), 4.0 * std::numbers::pi);
  const Curve quarter = *arcThrough({1, 0}, {std::numbers::sqrt2 / 2, std::numbers::sqrt2 / 2}, {0, 1});
  EXPECT_NEAR(lengthBetween(quarter, 0.0, 0.5), std::numbers::pi / 4, 1e-15);
}

TEST(Curve, LengthOfAParabolaIsClosedForm) {
  // Through three points with equal chords: x = 2t - 1, y = 1 - x², of length √5 + asinh(2)/2.
  const Curve parabola = makeSpline({{-1, 0}, {0, 1}, {1, 0}});
  EXPECT_NEAR(pointAt(parabola, 0.25).y, 0.75, 1e-15);
  EXPECT_NEAR(lengthBetween(parabola, 0.0, 1.0), std::sqrt(5.0) + 0.5 * std::asinh(2.0), 1e-7);
  EXPECT_NEAR(curvatureAt(parabola, 0.5), 2.0, 1e-12);
}

TEST(Curve, LengthAddsUp) {
  for (const Curve& curve : oneOfEach()) {
    double sum = 0.0;
    for (int i = 0; i < 40; ++i) sum += lengthBetween(curve, i / 40.0, (i + 1) / 40.0);
    const double whole = lengthBetween(curve, 0.0, 1.0);
    EXPECT_NEAR(sum, whole, 1e-6 * whole);
    EXPECT_EQ(lengthBetween(curve, 0.3, 0.3), 0.0);
  }
}

TEST(Curve, ReversedIsTheSameCurveFromTheOtherEnd) {
  for (const Curve& curve : oneOfEach()) {
    const Curve back = reversed(curve);
    EXPECT_EQ(back.a, curve.b);
    EXPECT_EQ(back.b, curve.a);
    for (double t = 0.0; t <= 1.0; t += 0.0625) {
      EXPECT_LT(distance(pointAt(back, t), pointAt(curve, 1.0 - t)), 1e-14);
      EXPECT_NEAR(lengthBetween(back, 0.0, t), lengthBetween(curve, 1.0 - t, 1.0), 1e-6);
    }
  }
}

TEST(Arc, RunsThroughItsThreePointsEitherWay) {
  const Point a{3, 1};
  const Point through{1, 3};
  const Point b{-1, 1};
  const Curve left = *arcThrough(a, through, b);  // about (1, 1), counter-clockwise
  EXPECT_NEAR(left.sweptAngle, trig::kPi, 1e-15);
  EXPECT_LT(distance(pointAt(left, 0.5), through), 1e-15);
  const Curve right = *arcThrough(b, through, a);
  EXPECT_NEAR(right.sweptAngle, -trig::kPi, 1e-15);
  const Curve mostOfIt = *arcThrough({3, 1}, {-1, 1}, {1, -1});  // three quarters of the circle
  EXPECT_NEAR(mostOfIt.sweptAngle, 1.5 * trig::kPi, 1e-15);
}

TEST(Arc, StraightOrNearlySoIsNone) {
  EXPECT_FALSE(arcThrough({0, 0}, {1, 1}, {2, 2}));
  EXPECT_FALSE(arcThrough({0, 0}, {1, 1e-9}, {2, 0}));
  EXPECT_TRUE(arcThrough({0, 0}, {1, 1e-4}, {2, 0}));
}

TEST(Spline, PassesThroughItsPoints) {
  const Curve curve = wave();
  for (std::size_t i = 0; i < curve.knots.size(); ++i) EXPECT_EQ(pointAt(curve, curve.params[i]), curve.knots[i]);
}

void expectSmoothAt(const Curve& curve, double before, double after) {
  const Point tangentBefore = derivativeAt(curve, before);
  const Point tangentAfter = derivativeAt(curve, after);
  EXPECT_LT(distance(tangentBefore, tangentAfter), 1e-5 * length(tangentAfter));
  EXPECT_NEAR(curvatureAt(curve, before), curvatureAt(curve, after), 1e-5);
}

TEST(Spline, SlopeAndCurvatureAreContinuous) {
  const Curve curve = wave();
  for (std::size_t i = 1; i + 1 < curve.params.size(); ++i) {
    expectSmoothAt(curve, curve.params[i] - 1e-9, curve.params[i] + 1e-9);
  }
  const Curve closed = makeClosedSpline(ellipse(9, 2, 1));
  for (std::size_t i = 1; i + 1 < closed.params.size(); ++i) {
    expectSmoothAt(closed, closed.params[i] - 1e-9, closed.params[i] + 1e-9);
  }
  EXPECT_EQ(closed.a, closed.b);
  expectSmoothAt(closed, 1.0 - 1e-9, 1e-9);
}

TEST(Spline, ClosedSplineConvergesToTheCircleWithTheFourthOrder) {
  const auto lengthError = [](int points) {
    return std::fabs(lengthBetween(makeClosedSpline(ellipse(points, 1, 1)), 0.0, 1.0) - 2.0 * std::numbers::pi);
  };
  EXPECT_LT(lengthError(24), 5e-5);
  EXPECT_NEAR(lengthError(24) / lengthError(48), 16.0, 0.5);
  const Curve curve = makeClosedSpline(ellipse(24, 1, 1));
  for (double t = 0.01; t < 1.0; t += 0.013) {
    EXPECT_NEAR(length(pointAt(curve, t)), 1.0, 2e-5);
    EXPECT_NEAR(curvatureAt(curve, t), 1.0, 1.2e-2);
  }
}

TEST(Spline, TwoPointsMakeALine) { EXPECT_EQ(makeSpline({{0, 0}, {1, 2}}).kind, CurveKind::line); }

TEST(Spline, StraightPointsMakeAStraightCurve) {
  const Curve curve = makeSpline({{0, 0}, {1, 1}, {3, 3}, {3.5, 3.5}});
  for (double t = 0.0; t <= 1.0; t += 0.03) EXPECT_NEAR(pointAt(curve, t).x, pointAt(curve, t).y, 1e-15);
}

TEST(Spline, PointsTooCloseAreFound) {
  EXPECT_EQ(tooCloseForSpline({{0, 0}, {1, 0}, {2, 0}}), -1);
  EXPECT_EQ(tooCloseForSpline({{0, 0}, {1, 0}, {1 + 1e-10, 0}, {2, 0}}), 1);
}

TEST(Curve, BitsAreTheSameEverywhere) {
  std::uint64_t digest = 0xcbf29ce484222325u;
  const auto mix = [&](double value) { digest = (digest ^ std::bit_cast<std::uint64_t>(value)) * 0x100000001b3u; };
  for (const Curve& curve : oneOfEach()) {
    for (double t = 0.0; t <= 1.0; t += 0.001) {
      mix(pointAt(curve, t).x);
      mix(derivativeAt(curve, t).y);
      mix(curvatureAt(curve, t));
      mix(lengthBetween(curve, 0.5 * t, t));
    }
  }
  EXPECT_EQ(digest, 16194622423016827077u);
}

}  // namespace
}  // namespace triscope::curve_test
