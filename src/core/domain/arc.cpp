#include "core/domain/arc.h"

#include <cmath>

#include "core/geometry/circumcircle.h"
#include "core/geometry/predicates.h"
#include "core/geometry/trig.h"

namespace triscope {

namespace {

constexpr double kFlattest = 1e5;  // radius over chord

double angleOf(Point direction) { return trig::atan2(direction.y, direction.x); }

}  // namespace

std::optional<Curve> arcThrough(Point a, Point through, Point b) {
  const int turn = orient2d(a, through, b);
  if (turn == 0) return std::nullopt;
  const Circumcircle circle = circumcircle(a, through, b);
  const double radius = std::sqrt(circle.squaredRadius);
  if (!(radius <= kFlattest * distance(a, b))) return std::nullopt;
  Curve arc{.kind = CurveKind::arc, .a = a, .b = b, .centre = circle.centre, .radius = radius};
  arc.startAngle = angleOf(a - arc.centre);
  arc.sweptAngle = angleOf(b - arc.centre) - arc.startAngle;
  if (turn > 0 && arc.sweptAngle <= 0.0) arc.sweptAngle += 2.0 * trig::kPi;
  if (turn < 0 && arc.sweptAngle >= 0.0) arc.sweptAngle -= 2.0 * trig::kPi;
  return arc;
}

Curve makeCircle(Point centre, double radius) {
  const Point start{centre.x + radius, centre.y};
  return {.kind = CurveKind::arc,
          .a = start,
          .b = start,
          .centre = centre,
          .radius = radius,
          .startAngle = 0.0,
          .sweptAngle = 2.0 * trig::kPi};
}

}  // namespace triscope
