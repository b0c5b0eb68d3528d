#include "core/density/sources.h"

#include <algorithm>
#include <cmath>

#include "core/density/constraint_search.h"
#include "core/density/quadtree.h"
#include "core/domain/shortest_line.h"

namespace triscope {

double lengthWanted(const DensityRequest& request, double minEdge) {
  return request.rank > 0 ? minEdge * rankLength(request.rank) : request.length;
}

Box boxOf(const DensityRequest& request, const Domain& domain) {
  if (request.where == DensityRequest::Where::point) return {request.at, request.at};
  const Box& all = domain.bounds;
  return {{std::max(request.at.x, all.lo.x), std::max(request.at.y, all.lo.y)},
          {std::min(request.to.x, all.hi.x), std::min(request.to.y, all.hi.y)}};
}

Box reachOf(const Constraint& constraint, const Domain& domain) {
  if (constraint.source == Rule::user_request && domain.density[constraint.curve].where == DensityRequest::Where::box)
    return boxOf(domain.density[constraint.curve], domain);
  return {constraint.at, constraint.at};
}

std::uint32_t samplesAlong(const Curve& curve, double length) {
  return static_cast<std::uint32_t>(std::clamp(lengthBetween(curve, 0.0, 1.0) / (2.0 * length), 1.0, 1e9)) + 1;
}

LoopDemand greediestAlong(const Domain& domain, double minEdge) {
  LoopDemand most;
  for (std::size_t k = 0; k < domain.density.size(); ++k) {
    const DensityRequest& request = domain.density[k];
    if (request.where != DensityRequest::Where::loop) continue;
    const double length = std::max(lengthWanted(request, minEdge), minEdge);
    double edges = 0.0;
    Point at;
    for (const Loop& loop : domain.loops) {
      if (loop.name != request.loop) continue;
      at = domain.curves[loop.firstCurve].a;
      for (std::uint32_t c = loop.firstCurve; c < loop.firstCurve + loop.curveCount; ++c)
        edges += std::floor(lengthBetween(domain.curves[c], 0.0, 1.0) / length);
    }
    if (edges > most.triangles) most = {edges, {at, length, Rule::user_request, static_cast<std::uint32_t>(k)}};
  }
  return most;
}

double finestLength(const Domain& domain, double minEdge) {
  const double shortest = shortestLine(domain).length;
  double finest = minEdge;
  while (0.75 * finest > shortest) finest *= 0.5;
  return finest;
}

std::optional<double> deriveMinEdge(const Domain& domain, const Settings& settings, const SearchNews& goesOn) {
  constexpr int kLooks = 64;  // between two looks at the clock, or at a key
  const double extent = std::max(domain.bounds.width(), domain.bounds.height());
  ConstraintSearch search = geometrySearch(domain, 1e-7 * extent);
  for (int looks = 1; carryOn(search, domain, settings); ++looks) {
    if (looks < kLooks || !goesOn) continue;
    if (!goesOn(fractionOf(search, domain))) return std::nullopt;
    looks = 0;
  }
  double finest = extent / 40.0;
  for (const Constraint& constraint : search.found) finest = std::min(finest, constraint.length);
  // The shortest kept edge takes a whole number of edges of that length.
  const double shortest = shortestLine(domain).length;
  if (shortest < 8.0 * finest) finest = shortest / std::max(1.0, std::ceil(shortest / finest - 1e-9));
  return finest;
}

}  // namespace triscope
