#include "core/density/sources.h"

#include <algorithm>
#include <cmath>

#include "core/density/boundary_tree.h"
#include "core/density/quadtree.h"
#include "core/domain/shortest_line.h"
#include "core/geometry/trig.h"

namespace triscope {
namespace {

constexpr double kFacing = -0.5;  // cosine between the normals of two pieces that face each other across a gap

constexpr double kMostInBox = 4e6;  // wishes: a box that needs more would hold over a hundred million triangles

struct Search {
  const Domain& domain;
  const Settings& settings;
  double minEdge;  // smallest length worth asking for; also the finest sampling
  double extent;
  std::vector<Constraint> found;

  void ask(Point at, double wish, Rule source, std::uint32_t curve) {
    found.push_back({at, std::max(wish, minEdge), source, curve});
  }
};

void curvature(Search& search, std::uint32_t index) {
  const Curve& curve = search.domain.curves[index];
  if (curve.kind == CurveKind::line) return;
  const double turn = search.settings.curvatureTurn * trig::kDegree;
  const double total = lengthBetween(curve, 0.0, 1.0);
  for (double t = 0.0; t < 1.0;) {
    const double bend = curvatureAt(curve, t);
    const double wish = bend > 0.0 ? turn / bend : search.extent;
    if (wish < 0.25 * search.extent) search.ask(pointAt(curve, t), wish, Rule::curvature, index);
    const double step = std::clamp(0.5 * wish, std::max(search.minEdge, 1e-4 * total), total / 32.0);
    t += step / std::max(length(derivativeAt(curve, t)), 1e-6 * total);
  }
}

void shortEdge(Search& search, std::uint32_t index) {
  const Curve& curve = search.domain.curves[index];
  if (curve.kind != CurveKind::line) return;
  const double wish = distance(curve.a, curve.b);
  // Not raised to Δx: the edge is kept however short it is.
  for (const Point at : {curve.a, midpoint(curve.a, curve.b), curve.b}) {
    search.found.push_back({at, wish, Rule::short_edge, index});
  }
}

// A kept edge takes a whole number of pieces, none below Δx: the shortest they can be. To ask for less along it leaves
// an edge of up to 2Δx among edges of Δx, and angles of 30°.
double shortestPiece(const Search& search, const Curve& curve) {
  if (curve.kind != CurveKind::line) return search.minEdge;
  const double whole = distance(curve.a, curve.b);
  return whole / std::max(1.0, std::floor(whole / search.minEdge * (1.0 + 1e-9)));
}

// Length asked for at a corner: Δx where a curved piece ends, a quarter of the shorter edge between straight ones.
double cornerWish(const Search& search, const Curve& before, const Curve& after) {
  if (before.kind != CurveKind::line || after.kind != CurveKind::line) return search.minEdge;
  const double quarter = 0.25 * std::min(distance(before.a, before.b), distance(after.a, after.b));
  return std::max({quarter, shortestPiece(search, before), shortestPiece(search, after)});
}

void corners(Search& search, const Loop& loop) {
  const double limit = trig::cos(search.settings.cornerTurn * trig::kDegree);
  for (std::uint32_t k = 0; k < loop.curveCount; ++k) {
    const std::uint32_t index = loop.firstCurve + k;
    const Curve& before = search.domain.curves[index];
    const bool last = k + 1 == loop.curveCount;
    if (loop.role == LoopRole::chain) {
      // The free ends of a chain are extreme points: a crack tip.
      if (k == 0) search.ask(before.a, cornerWish(search, before, before), Rule::corner, index);
      if (last) search.ask(before.b, cornerWish(search, before, before), Rule::corner, index);
      continue;
    }
    const Curve& after = search.domain.curves[last ? loop.firstCurve : index + 1];
    const Point in = derivativeAt(before, 1.0);
    const Point out = derivativeAt(after, 0.0);
    const bool reentrant = cross(in, out) < 0.0 || (cross(in, out) == 0.0 && dot(in, out) < 0.0);
    if (reentrant && dot(in, out) <= limit * length(in) * length(out)) {
      search.ask(after.a, cornerWish(search, before, after), Rule::corner, index);
    }
  }
}

void gapsOnSide(Search& search, const BoundaryTree& boundary, std::uint32_t index, double side) {
  const Curve& curve = search.domain.curves[index];
  const double total = lengthBetween(curve, 0.0, 1.0);
  for (double s = 0.0; s < total;) {
    const double t = std::min(s / total + 1e-3, 0.999);
    const Point at = pointAt(curve, t);
    const Point along = derivativeAt(curve, t);
    const Point normal = (side / length(along)) * perpendicular(along);
    const RayHit hit = castRay(boundary, search.domain, at, normal, index);
    double width = search.extent;
    if (hit.distance < 0.25 * search.extent) {
      const BoundaryPiece& piece = boundary.pieces[hit.piece];
      const Point facing = perpendicular(piece.b - piece.a);
      const double cosineBetween = dot(normal, facing) / length(facing);
      if (cosineBetween < kFacing || (piece.twoSided && cosineBetween > -kFacing)) {
        width = hit.distance;
        const double wish = std::max(search.settings.gapFraction * width, shortestPiece(search, curve));
        search.ask(at, wish, Rule::gap, index);
        search.ask(at + (0.5 * width) * normal, wish, Rule::gap, index);
        search.ask(at + width * normal, wish, Rule::gap, index);
      }
    }
    s += std::clamp(0.5 * width, std::max(search.minEdge, 1e-3 * total), total / 3.0);
  }
}

// What lies ahead of a corner that juts into the domain, between the normals of the pieces that meet there: rays along
// those normals pass it by on either side.
void gapAhead(Search& search, const BoundaryTree& boundary, std::uint32_t index, Point in, Point out, Point at) {
  const Nearest wall = nearestIn(boundary, search.domain, {at, perpendicular(in), perpendicular(out)});
  if (wall.distance >= 0.25 * search.extent) return;
  const std::vector<Curve>& curves = search.domain.curves;
  const double wish = std::max({search.settings.gapFraction * wall.distance, shortestPiece(search, curves[index]),
                                shortestPiece(search, curves[boundary.pieces[wall.piece].curve])});
  for (const Point p : {at, midpoint(at, wall.at), wall.at}) search.ask(p, wish, Rule::gap, index);
}

void gapsAtCorners(Search& search, const BoundaryTree& boundary, const Loop& loop) {
  for (std::uint32_t k = 0; k < loop.curveCount; ++k) {
    const std::uint32_t index = loop.firstCurve + k;
    const Curve& curve = search.domain.curves[index];
    const Point in = derivativeAt(curve, 1.0);
    const bool last = k + 1 == loop.curveCount;
    if (loop.role == LoopRole::chain && k == 0) {
      const Point back = -1.0 * derivativeAt(curve, 0.0);
      gapAhead(search, boundary, index, back, -1.0 * back, curve.a);
    }
    if (loop.role == LoopRole::chain && last) {
      gapAhead(search, boundary, index, in, -1.0 * in, curve.b);
      continue;
    }
    const Point out = derivativeAt(search.domain.curves[last ? loop.firstCurve : index + 1], 0.0);
    const double turn = cross(in, out);
    if (turn < 0.0) gapAhead(search, boundary, index, in, out, curve.b);
    if (turn > 0.0 && loop.role == LoopRole::chain) gapAhead(search, boundary, index, -1.0 * out, -1.0 * in, curve.b);
  }
}

void gaps(Search& search) {
  const BoundaryTree boundary = boundaryTreeOf(search.domain, 10.0 * trig::kDegree);
  for (const Loop& loop : search.domain.loops) {
    for (std::uint32_t c = loop.firstCurve; c < loop.firstCurve + loop.curveCount; ++c) {
      gapsOnSide(search, boundary, c, 1.0);
      if (loop.role == LoopRole::chain) gapsOnSide(search, boundary, c, -1.0);
    }
    gapsAtCorners(search, boundary, loop);
  }
}

void requests(Search& search) {
  for (std::size_t k = 0; k < search.domain.density.size(); ++k) {
    const DensityRequest& request = search.domain.density[k];
    const double wish = lengthWanted(request, search.minEdge);
    const auto index = static_cast<std::uint32_t>(k);
    if (request.where == DensityRequest::Where::point) {
      search.ask(request.at, wish, Rule::user_request, index);
    } else if (request.where == DensityRequest::Where::box) {
      // One wish per cell of the rank that holds the length: its side is at least 4 lengths.
      const Point size = request.to - request.at;
      double step = 2.0 * std::max(wish, search.minEdge);
      step = std::max(step, std::sqrt(size.x * size.y / kMostInBox));
      const int nx = static_cast<int>(std::clamp(size.x / step, 1.0, kMostInBox)) + 1;
      const int ny = static_cast<int>(std::clamp(size.y / step, 1.0, kMostInBox)) + 1;
      for (int j = 0; j <= ny; ++j) {
        for (int i = 0; i <= nx; ++i) {
          search.ask(request.at + Point{size.x * i / nx, size.y * j / ny}, wish, Rule::user_request, index);
        }
      }
    } else {
      for (const Loop& loop : search.domain.loops) {
        if (loop.name != request.loop) continue;
        for (std::uint32_t c = loop.firstCurve; c < loop.firstCurve + loop.curveCount; ++c) {
          const Curve& curve = search.domain.curves[c];
          const double total = lengthBetween(curve, 0.0, 1.0);
          const int n = static_cast<int>(std::clamp(total / (2.0 * std::max(wish, search.minEdge)), 1.0, 1e6)) + 1;
          for (int i = 0; i <= n; ++i)
            search.ask(pointAt(curve, static_cast<double>(i) / n), wish, Rule::user_request, index);
        }
      }
    }
  }
}

double extentOf(const Domain& domain) { return std::max(domain.bounds.width(), domain.bounds.height()); }

void geometry(Search& search) {
  const auto curves = static_cast<std::uint32_t>(search.domain.curves.size());
  for (std::uint32_t c = 0; c < curves; ++c) curvature(search, c);
  for (std::uint32_t c = 0; c < curves; ++c) shortEdge(search, c);
  gaps(search);
}

}  // namespace

double lengthWanted(const DensityRequest& request, double minEdge) {
  return request.rank > 0 ? minEdge * rankLength(request.rank) : request.length;
}

std::vector<Constraint> findConstraints(const Domain& domain, const Settings& settings, double minEdge) {
  Search search{domain, settings, minEdge, extentOf(domain), {}};
  requests(search);
  for (const Loop& loop : domain.loops) corners(search, loop);
  geometry(search);
  return std::move(search.found);
}

double finestLength(const Domain& domain, double minEdge) {
  const double shortest = shortestLine(domain).length;
  double finest = minEdge;
  while (0.75 * finest > shortest) finest *= 0.5;
  return finest;
}

double deriveMinEdge(const Domain& domain, const Settings& settings) {
  const double extent = extentOf(domain);
  Search search{domain, settings, 1e-7 * extent, extent, {}};
  geometry(search);
  double finest = extent / 40.0;
  for (const Constraint& constraint : search.found) finest = std::min(finest, constraint.length);
  // The shortest kept edge takes a whole number of edges of that length.
  const double shortest = shortestLine(domain).length;
  if (shortest < 8.0 * finest) finest = shortest / std::max(1.0, std::ceil(shortest / finest - 1e-9));
  return finest;
}

}  // namespace triscope
