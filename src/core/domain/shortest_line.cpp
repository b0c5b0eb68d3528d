#include "core/domain/shortest_line.h"

namespace triscope {

ShortestLine shortestLine(const Domain& domain) {
  ShortestLine shortest;
  for (std::uint32_t c = 0; c < domain.curves.size(); ++c) {
    const Curve& curve = domain.curves[c];
    if (curve.kind != CurveKind::line) continue;
    const double length = distance(curve.a, curve.b);
    if (length < shortest.length) shortest = {length, c};
  }
  return shortest;
}

}  // namespace triscope
