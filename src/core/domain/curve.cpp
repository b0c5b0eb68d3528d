#include "core/domain/curve.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/geometry/trig.h"

namespace triscope {

namespace {

/// Cubic Hermite span of a spline: ends p0, p1 and slopes s0, s1 over a parameter width.
struct SplineSpan {
  Point p0, p1, s0, s1;
  double start = 0.0;
  double width = 1.0;
};

std::size_t spanCount(const Curve& curve) { return curve.knots.size() - 1; }

SplineSpan spanOf(const Curve& curve, std::size_t k) {
  return {curve.knots[k],      curve.knots[k + 1], curve.slopes[k],
          curve.slopes[k + 1], curve.params[k],    curve.params[k + 1] - curve.params[k]};
}

std::size_t spanAt(const Curve& curve, double t) {
  const auto after = std::upper_bound(curve.params.begin(), curve.params.end(), t);
  const auto k = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - curve.params.begin() - 1, 0));
  return std::min(k, spanCount(curve) - 1);
}

Point valueOf(const SplineSpan& span, double t) {
  const double u = (t - span.start) / span.width;
  const double v = 1.0 - u;
  const double h1 = u * u * (3.0 - 2.0 * u);
  const Point along = (u * v * v * span.width) * span.s0 - (u * u * v * span.width) * span.s1;
  return (1.0 - h1) * span.p0 + h1 * span.p1 + along;
}

Point derivativeOf(const SplineSpan& span, double t) {
  const double u = (t - span.start) / span.width;
  const double v = 1.0 - u;
  const Point chord = (1.0 / span.width) * (span.p1 - span.p0);
  return (6.0 * u * v) * chord + (v * (1.0 - 3.0 * u)) * span.s0 + (u * (3.0 * u - 2.0)) * span.s1;
}

Point secondDerivativeOf(const SplineSpan& span, double t) {
  const double u = (t - span.start) / span.width;
  const Point chord = (1.0 / span.width) * (span.p1 - span.p0);
  const Point sum = (6.0 - 12.0 * u) * chord + (6.0 * u - 4.0) * span.s0 + (6.0 * u - 2.0) * span.s1;
  return (1.0 / span.width) * sum;
}

/// Arc length of one span between two parameters in it: seven-point Gauss-Legendre on each half.
double spanLength(const SplineSpan& span, double t0, double t1) {
  constexpr std::array<double, 4> nodes{0.0, 0.4058451513773971669, 0.7415311855993944399, 0.9491079123427585245};
  constexpr std::array<double, 4> weights{0.4179591836734693878, 0.3818300505051189449, 0.2797053914892766679,
                                          0.1294849661688696933};
  const auto speed = [&](double t) { return length(derivativeOf(span, t)); };
  double total = 0.0;
  for (int half = 0; half < 2; ++half) {
    const double reach = 0.25 * (t1 - t0);
    const double middle = t0 + (half == 0 ? 1.0 : 3.0) * reach;
    double sum = weights[0] * speed(middle);
    for (std::size_t i = 1; i < nodes.size(); ++i) {
      sum += weights[i] * (speed(middle - nodes[i] * reach) + speed(middle + nodes[i] * reach));
    }
    total += reach * sum;
  }
  return total;
}

}  // namespace

Point pointAt(const Curve& curve, double t) {
  if (t <= 0.0) return curve.a;
  if (t >= 1.0) return curve.b;
  switch (curve.kind) {
    case CurveKind::arc: {
      const trig::SinCos direction = trig::sinCos(curve.startAngle + t * curve.sweptAngle);
      return curve.centre + curve.radius * Point{direction.cos, direction.sin};
    }
    case CurveKind::spline:
      return valueOf(spanOf(curve, spanAt(curve, t)), t);
    case CurveKind::line:
      break;
  }
  return curve.a + t * (curve.b - curve.a);
}

Point derivativeAt(const Curve& curve, double t) {
  switch (curve.kind) {
    case CurveKind::arc: {
      const trig::SinCos direction = trig::sinCos(curve.startAngle + t * curve.sweptAngle);
      return (curve.radius * curve.sweptAngle) * Point{-direction.sin, direction.cos};
    }
    case CurveKind::spline:
      return derivativeOf(spanOf(curve, spanAt(curve, t)), t);
    case CurveKind::line:
      break;
  }
  return curve.b - curve.a;
}

double curvatureAt(const Curve& curve, double t) {
  switch (curve.kind) {
    case CurveKind::arc:
      return 1.0 / curve.radius;
    case CurveKind::spline: {
      const SplineSpan span = spanOf(curve, spanAt(curve, t));
      const Point first = derivativeOf(span, t);
      const double speed = length(first);
      if (speed == 0.0) return 0.0;  // a cusp has no curvature
      return std::fabs(cross(first, secondDerivativeOf(span, t))) / (speed * speed * speed);
    }
    case CurveKind::line:
      break;
  }
  return 0.0;
}

double lengthBetween(const Curve& curve, double t0, double t1) {
  switch (curve.kind) {
    case CurveKind::arc:
      return (t1 - t0) * curve.radius * std::fabs(curve.sweptAngle);
    case CurveKind::spline: {
      double total = 0.0;
      for (std::size_t k = spanAt(curve, t0); k < spanCount(curve) && curve.params[k] < t1; ++k) {
        const SplineSpan span = spanOf(curve, k);
        const double from = std::max(t0, span.start);
        const double to = std::min(t1, curve.params[k + 1]);
        if (from < to) total += spanLength(span, from, to);
      }
      return total;
    }
    case CurveKind::line:
      break;
  }
  return (t1 - t0) * distance(curve.a, curve.b);
}

}  // namespace triscope
