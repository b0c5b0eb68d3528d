#include "ring.h"

#include <numbers>

namespace triscope::bench {
namespace {

constexpr double kHalfSide = 8.0;
/// Measured with this program: vertices · minEdge once steps 1-5 are over.
constexpr double kVerticesTimesMinEdge = 94.0;

Curve line(Point a, Point b) { return Curve{.kind = CurveKind::line, .a = a, .b = b}; }

/// Half of the unit circle, clockwise: the domain lies to the left of a hole's curves.
Curve halfCircle(Point a, Point b, double startAngle) {
  return Curve{.kind = CurveKind::arc,
               .a = a,
               .b = b,
               .centre = {0.0, 0.0},
               .radius = 1.0,
               .startAngle = startAngle,
               .sweptAngle = -std::numbers::pi};
}

}  // namespace

std::shared_ptr<const Domain> ring(double minEdge) {
  Domain domain;
  domain.name = "graded ring";
  domain.minEdgeLength = minEdge;
  const Point sw{-kHalfSide, -kHalfSide}, se{kHalfSide, -kHalfSide}, ne{kHalfSide, kHalfSide},
      nw{-kHalfSide, kHalfSide};
  const Point east{1.0, 0.0}, west{-1.0, 0.0};
  domain.curves = {line(sw, se),
                   line(se, ne),
                   line(ne, nw),
                   line(nw, sw),
                   halfCircle(east, west, 0.0),
                   halfCircle(west, east, std::numbers::pi)};
  domain.loops = {Loop{.name = "outer", .role = LoopRole::outer, .firstCurve = 0, .curveCount = 4},
                  Loop{.name = "disc", .role = LoopRole::hole, .firstCurve = 4, .curveCount = 2}};
  DensityRequest request;
  request.where = DensityRequest::Where::loop;
  request.loop = "disc";
  request.rank = 1;
  domain.density = {request};
  domain.bounds.include(sw);
  domain.bounds.include(ne);
  return std::make_shared<const Domain>(std::move(domain));
}

double minEdgeFor(double vertices) { return kVerticesTimesMinEdge / vertices; }

}  // namespace triscope::bench
