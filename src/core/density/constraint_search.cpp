#include "core/density/constraint_search.h"

#include <algorithm>
#include <cmath>

#include "core/density/sources.h"
#include "core/domain/loop_of.h"
#include "core/geometry/trig.h"

namespace triscope {
namespace {

using Part = ConstraintSearch::Part;

constexpr double kFacing = -0.5;  // cosine between the normals of two pieces that face each other across a gap

/// What one look sees.
struct Look {
  ConstraintSearch& search;
  const Domain& domain;
  const Settings& settings;

  void ask(Point at, double wish, Rule source, std::uint32_t curve) const {
    search.found.push_back({at, std::max(wish, search.minEdge), source, curve});
  }
};

// So much, but no less than the least and no more than the most: along a curve that is short beside Δx the most is
// below the least, and holds.
double stepOf(double wish, double least, double most) { return std::min(std::max(wish, least), most); }

void curvature(const Look& look, std::uint32_t index) {
  const Curve& curve = look.domain.curves[index];
  if (curve.kind == CurveKind::line) return;
  const double extent = look.search.extent;
  const double turn = look.settings.curvatureTurn * trig::kDegree;
  const double total = lengthBetween(curve, 0.0, 1.0);
  for (double t = 0.0; t < 1.0;) {
    const double bend = curvatureAt(curve, t);
    const double wish = bend > 0.0 ? turn / bend : extent;
    if (wish < 0.25 * extent) look.ask(pointAt(curve, t), wish, Rule::curvature, index);
    const double step = stepOf(0.5 * wish, std::max(look.search.minEdge, 1e-4 * total), total / 32.0);
    t += step / std::max(length(derivativeAt(curve, t)), 1e-6 * total);
  }
}

void shortEdge(const Look& look, std::uint32_t index) {
  const Curve& curve = look.domain.curves[index];
  if (curve.kind != CurveKind::line) return;
  const double wish = distance(curve.a, curve.b);
  // Not raised to Δx: the edge is kept however short it is.
  for (const Point at : {curve.a, midpoint(curve.a, curve.b), curve.b})
    look.search.found.push_back({at, wish, Rule::short_edge, index});
}

// A kept edge takes a whole number of pieces, none below Δx: the shortest they can be. To ask for less along it leaves
// an edge of up to 2Δx among edges of Δx, and angles of 30°.
double shortestPiece(const Look& look, const Curve& curve) {
  if (curve.kind != CurveKind::line) return look.search.minEdge;
  const double whole = distance(curve.a, curve.b);
  return whole / std::max(1.0, std::floor(whole / look.search.minEdge * (1.0 + 1e-9)));
}

// Length asked for at a corner: Δx where a curved piece ends, a quarter of the shorter edge between straight ones.
double cornerWish(const Look& look, const Curve& before, const Curve& after) {
  if (before.kind != CurveKind::line || after.kind != CurveKind::line) return look.search.minEdge;
  const double quarter = 0.25 * std::min(distance(before.a, before.b), distance(after.a, after.b));
  return std::max({quarter, shortestPiece(look, before), shortestPiece(look, after)});
}

// The corner that a curve ends in; of the first and last curve of a chain also the free ends.
void corner(const Look& look, std::uint32_t index) {
  const Loop& loop = loopOf(look.domain, index);
  const Curve& before = look.domain.curves[index];
  const bool last = index + 1 == loop.firstCurve + loop.curveCount;
  if (loop.role == LoopRole::chain) {
    // The free ends of a chain are extreme points: a crack tip.
    if (index == loop.firstCurve) look.ask(before.a, cornerWish(look, before, before), Rule::corner, index);
    if (last) look.ask(before.b, cornerWish(look, before, before), Rule::corner, index);
    return;
  }
  const double limit = trig::cos(look.settings.cornerTurn * trig::kDegree);
  const Curve& after = look.domain.curves[last ? loop.firstCurve : index + 1];
  const Point in = derivativeAt(before, 1.0);
  const Point out = derivativeAt(after, 0.0);
  const bool reentrant = cross(in, out) < 0.0 || (cross(in, out) == 0.0 && dot(in, out) < 0.0);
  if (reentrant && dot(in, out) <= limit * length(in) * length(out))
    look.ask(after.a, cornerWish(look, before, after), Rule::corner, index);
}

// One ray off a curve. False when it starts beyond the curve's end.
bool gapAcross(const Look& look) {
  ConstraintSearch& search = look.search;
  const Curve& curve = look.domain.curves[search.index];
  const double total = lengthBetween(curve, 0.0, 1.0);
  if (!(search.along < total)) return false;
  const double t = std::min(search.along / total + 1e-3, 0.999);
  const Point at = pointAt(curve, t);
  const Point along = derivativeAt(curve, t);
  const Point normal = ((search.backwards ? -1.0 : 1.0) / length(along)) * perpendicular(along);
  const RayHit hit = castRay(search.boundary, look.domain, at, normal, search.index);
  double width = search.extent;
  if (hit.distance < 0.25 * search.extent) {
    const BoundaryPiece& piece = search.boundary.pieces[hit.piece];
    const Point facing = perpendicular(piece.b - piece.a);
    const double cosineBetween = dot(normal, facing) / length(facing);
    if (cosineBetween < kFacing || (piece.twoSided && cosineBetween > -kFacing)) {
      width = hit.distance;
      const double wish = std::max(look.settings.gapFraction * width, shortestPiece(look, curve));
      look.ask(at, wish, Rule::gap, search.index);
      look.ask(at + (0.5 * width) * normal, wish, Rule::gap, search.index);
      look.ask(at + width * normal, wish, Rule::gap, search.index);
    }
  }
  search.along += stepOf(0.5 * width, std::max(search.minEdge, 1e-3 * total), total / 3.0);
  return true;
}

// What lies ahead of a corner that juts into the domain, between the normals of the pieces that meet there: rays along
// those normals pass it by on either side.
void gapAhead(const Look& look, std::uint32_t index, Point in, Point out, Point at) {
  const BoundaryTree& boundary = look.search.boundary;
  const Nearest wall = nearestIn(boundary, look.domain, {at, perpendicular(in), perpendicular(out)});
  if (wall.distance >= 0.25 * look.search.extent) return;
  const std::vector<Curve>& curves = look.domain.curves;
  const double wish = std::max({look.settings.gapFraction * wall.distance, shortestPiece(look, curves[index]),
                                shortestPiece(look, curves[boundary.pieces[wall.piece].curve])});
  for (const Point p : {at, midpoint(at, wall.at), wall.at}) look.ask(p, wish, Rule::gap, index);
}

void gapAtCorner(const Look& look, const Loop& loop, std::uint32_t index) {
  const Curve& curve = look.domain.curves[index];
  const Point in = derivativeAt(curve, 1.0);
  const bool last = index + 1 == loop.firstCurve + loop.curveCount;
  if (loop.role == LoopRole::chain && index == loop.firstCurve) {
    const Point back = -1.0 * derivativeAt(curve, 0.0);
    gapAhead(look, index, back, -1.0 * back, curve.a);
  }
  if (loop.role == LoopRole::chain && last) return gapAhead(look, index, in, -1.0 * in, curve.b);
  const Point out = derivativeAt(look.domain.curves[last ? loop.firstCurve : index + 1], 0.0);
  const double turn = cross(in, out);
  if (turn < 0.0) gapAhead(look, index, in, out, curve.b);
  if (turn > 0.0 && loop.role == LoopRole::chain) gapAhead(look, index, -1.0 * out, -1.0 * in, curve.b);
}

// One place of a request. Along a loop there is one for every two lengths; a box is one wish for all its cells.
void request(const Look& look) {
  ConstraintSearch& search = look.search;
  const DensityRequest& request = look.domain.density[search.index];
  const double wish = lengthWanted(request, search.minEdge);
  if (request.where != DensityRequest::Where::loop) {
    const Box box = boxOf(request, look.domain);
    look.ask(midpoint(box.lo, box.hi), wish, Rule::user_request, search.index++);
    return;
  }
  if (search.curve == look.domain.curves.size()) {
    search.curve = 0;
    ++search.index;
    return;
  }
  const Loop& loop = loopOf(look.domain, search.curve);
  if (loop.name != request.loop) {
    search.curve = loop.firstCurve + loop.curveCount;
    return;
  }
  const std::uint32_t n = samplesAlong(look.domain.curves[search.curve], std::max(wish, search.minEdge));
  const double t = static_cast<double>(search.sample) / n;
  look.ask(pointAt(look.domain.curves[search.curve], t), wish, Rule::user_request, search.index);
  if (search.sample++ < n) return;
  search.sample = 0;
  ++search.curve;
}

// From one curve to the next; to the next part after the last.
void next(ConstraintSearch& search, const Domain& domain) {
  search.along = 0.0;
  search.backwards = false;
  if (++search.index < domain.curves.size()) return;
  search.index = 0;
  search.part = static_cast<Part>(static_cast<int>(search.part) + 1);
}

}  // namespace

ConstraintSearch searchFor(const Domain& domain, double minEdge) {
  ConstraintSearch search = geometrySearch(domain, minEdge);
  search.part = domain.density.empty() ? Part::corners : Part::requests;
  return search;
}

ConstraintSearch geometrySearch(const Domain& domain, double minEdge) {
  ConstraintSearch search;
  search.part = Part::curvature;
  search.minEdge = minEdge;
  search.extent = std::max(domain.bounds.width(), domain.bounds.height());
  return search;
}

bool carryOn(ConstraintSearch& search, const Domain& domain, const Settings& settings) {
  const Look look{search, domain, settings};
  switch (search.part) {
    case Part::requests:
      request(look);
      if (search.index == domain.density.size()) {
        search.index = 0;
        search.part = Part::corners;
      }
      return true;
    case Part::corners:
      corner(look, search.index);
      next(search, domain);
      return true;
    case Part::curvature:
      curvature(look, search.index);
      next(search, domain);
      return true;
    case Part::short_edges:
      shortEdge(look, search.index);
      next(search, domain);
      if (search.part == Part::gaps) search.boundary = boundaryTreeOf(domain, 10.0 * trig::kDegree);
      return true;
    case Part::gaps: {
      if (gapAcross(look)) return true;
      const Loop& loop = loopOf(domain, search.index);
      search.along = 0.0;
      if (loop.role == LoopRole::chain && !search.backwards) {
        search.backwards = true;
        return true;
      }
      search.backwards = false;
      if (++search.index < loop.firstCurve + loop.curveCount) return true;
      search.index = loop.firstCurve;
      search.part = Part::gaps_at_corners;
      return true;
    }
    case Part::gaps_at_corners: {
      const Loop& loop = loopOf(domain, search.index);
      gapAtCorner(look, loop, search.index);
      if (++search.index == domain.curves.size())
        search.part = Part::over;
      else if (search.index == loop.firstCurve + loop.curveCount)
        search.part = Part::gaps;
      return search.part != Part::over;
    }
    case Part::over:
      break;
  }
  return false;
}

double fractionOf(const ConstraintSearch& search, const Domain& domain) {
  if (search.part == Part::over) return 1.0;
  if (search.part < Part::gaps) return 0.0;  // nearly all the time goes into gaps
  return static_cast<double>(search.index) / static_cast<double>(domain.curves.size());
}

}  // namespace triscope
