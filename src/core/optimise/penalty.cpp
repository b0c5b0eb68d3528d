#include "core/optimise/penalty.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/trig.h"

namespace triscope {
namespace {

constexpr double kEdgeWeight = 0.25;
constexpr double kAreaWeight = 0.3;
constexpr double kLengthWeight = 0.3;
constexpr double kTurnedOver = 1e30;
constexpr double kShortestEdge = 0.73, kLongestEdge = 1.38;  // edge over the length wanted

// So far beyond the aims counts as kept to.
constexpr double kAngleSlack = 0.2;  // degrees
constexpr double kAreaSlack = 0.01;
constexpr double kEdgeSlack = 0.003;

double cotangent(double degrees) {
  const trig::SinCos t = trig::sinCos(degrees * trig::kDegree);
  return t.cos / t.sin;
}

double ofLength(const PenaltyLimits& limits, double squaredEdge, double wanted) {
  const double part = squaredEdge / (wanted * wanted);
  if (part > limits.longest) return squared(kLengthWeight * (part - limits.longest));
  return part < limits.shortest ? squared(kLengthWeight * (limits.shortest - part)) : 0.0;
}

double ofPair(const PenaltyLimits& limits, double a, double b) {
  const double large = std::max(a, b), small = std::min(a, b);
  return large > limits.areaRatio * small ? squared(kAreaWeight * (large / small - limits.areaRatio)) : 0.0;
}

double ofTriangle(const PenaltyLimits& limits, Point a, Point b, Point c) {
  const Point ab = b - a, bc = c - b, ca = a - c;
  const double area = cross(ab, bc);
  if (!(area > 0.0)) return kTurnedOver;
  const double inverse = 1.0 / area;
  double sum = 0.0;
  for (const double cot : {-dot(ab, ca) * inverse, -dot(ab, bc) * inverse, -dot(bc, ca) * inverse}) {
    if (cot > limits.mostCotangent) sum += squared(limits.lowWeight * (cot - limits.mostCotangent));
    if (cot < limits.leastCotangent) sum += squared(limits.leastCotangent - cot);
  }
  const double l = squaredLength(ab), m = squaredLength(bc), r = squaredLength(ca);
  const double longest = std::max({l, m, r}), shortest = std::min({l, m, r});
  if (longest > limits.squaredEdgeRatio * shortest)
    sum += squared(kEdgeWeight * (longest / shortest - limits.squaredEdgeRatio));
  return sum;
}

// Whether the input itself draws the border edge between them: its length is nobody's fault.
bool drawnByInput(const Mesh& mesh, Vertex a, Vertex b) {
  return mesh.kinds[a] == VertexKind::kept && mesh.kinds[b] == VertexKind::kept;
}

}  // namespace

PenaltyLimits limitsFor(const Aims& aims) {
  PenaltyLimits limits;
  limits.mostCotangent = cotangent(aims.lowestAngle);
  limits.leastCotangent = cotangent(aims.highestAngle);
  limits.lowWeight = 1.0 / (1.0 + squared(limits.mostCotangent));
  limits.squaredEdgeRatio = squared(aims.edgeRatio);
  limits.areaRatio = aims.areaRatio;
  limits.shortest = squared(kShortestEdge);
  limits.longest = squared(kLongestEdge);
  return limits;
}

Aims withSlack(const Aims& aims) {
  return {aims.lowestAngle - kAngleSlack, aims.highestAngle + kAngleSlack, aims.areaRatio + kAreaSlack,
          aims.edgeRatio + kEdgeSlack};
}

PenaltyLimits slackFor(const Aims& aims) {
  PenaltyLimits limits = limitsFor(withSlack(aims));
  limits.shortest = 0.0;
  limits.longest = 1e300;
  return limits;
}

double penaltyOf(const Mesh& mesh, const Sizes& sizes, Slot slot, const PenaltyLimits& limits) {
  const Triangle& t = triangleAt(mesh, slot);
  const Corners<Point> p{pointOf(mesh, t.v[0]), pointOf(mesh, t.v[1]), pointOf(mesh, t.v[2])};
  double sum = ofTriangle(limits, p[0], p[1], p[2]);
  const double area = cross(p[1] - p[0], p[2] - p[0]);
  for (int i = 0; i < 3; ++i) {
    const int k = next3(i), l = prev3(i);
    const bool border = !t.adj[i].exists();
    const bool drawn = constrained(mesh, halfOf(slot, i)) && drawnByInput(mesh, t.v[k], t.v[l]);
    const double wanted = 0.5 * (sizes[t.v[k]] + sizes[t.v[l]]);
    if (!drawn) sum += (border ? 1.0 : 0.5) * ofLength(limits, squaredDistance(p[k], p[l]), wanted);
    if (!border) sum += 0.5 * ofPair(limits, area, twiceArea(mesh, triangleOf(t.adj[i])));
  }
  return sum;
}

StarPenalty::StarPenalty(const Mesh& mesh, const Ring& ring, double hubSize, const PenaltyLimits& limits)
    : ring_(ring), limits_(limits) {
  for (std::size_t k = 0; k <= static_cast<std::size_t>(ring.count); ++k) wanted_[k] = 0.5 * (hubSize + ring.sizes[k]);
  for (std::size_t k = 0; k < static_cast<std::size_t>(ring.count); ++k) {
    const Half across = oppositeOf(mesh, ring.rim[k]);
    beyond_[k] = across.exists() ? twiceArea(mesh, triangleOf(across)) : 0.0;
  }
}

double StarPenalty::at(Point hub) { return sum<false>(hub); }

double StarPenalty::withSlopeAt(Point hub) {
  slope = {};
  xx = xy = yy = 0.0;
  return sum<true>(hub);
}

void StarPenalty::add(double residual, Point change) {
  slope = slope + residual * change;
  xx += change.x * change.x;
  xy += change.x * change.y;
  yy += change.y * change.y;
}

template <bool withSlope>
double StarPenalty::sum(Point hub) {
  const double shapes = triangles<withSlope>(hub);
  return shapes >= kTurnedOver ? shapes : shapes + lengths<withSlope>(hub) + pairs<withSlope>();
}

template <bool withSlope>
double StarPenalty::triangles(Point hub) {
  double sum = 0.0;
  obtuse = false;
  for (std::size_t k = 0; k < static_cast<std::size_t>(ring_.count); ++k) {
    const Point q = ring_.at[k], r = ring_.at[k + 1];
    const Point toQ = q - hub, toR = r - hub, rim = r - q;
    const double area = cross(toQ, toR);
    if (!(area > 0.0)) return kTurnedOver;
    area_[k] = area;
    const double inverse = 1.0 / area;
    const Point areaSlope{q.y - r.y, r.x - q.x};
    areaSlope_[k] = areaSlope;
    const std::array<double, 3> cots{dot(toQ, toR) * inverse, -dot(rim, toQ) * inverse, dot(rim, toR) * inverse};
    const double most = std::max({cots[0], cots[1], cots[2]}), least = std::min({cots[0], cots[1], cots[2]});
    if (least < 0.0) obtuse = true;
    if (most > limits_.mostCotangent || least < limits_.leastCotangent) {
      const std::array<Point, 3> dotSlopes{-1.0 * (toQ + toR), rim, -1.0 * rim};
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const double cot = cots[corner];
        const bool low = cot > limits_.mostCotangent;
        if (!low && !(cot < limits_.leastCotangent)) continue;
        const double weight = low ? limits_.lowWeight : -1.0;
        const double residual = weight * (cot - (low ? limits_.mostCotangent : limits_.leastCotangent));
        sum += residual * residual;
        if (withSlope) add(residual, (weight * inverse) * (dotSlopes[corner] - cot * areaSlope));
      }
    }
    const double lq = squaredLength(toQ), lr = squaredLength(toR), lm = squaredLength(rim);
    const double longest = std::max({lq, lr, lm}), shortest = std::min({lq, lr, lm});
    if (longest > limits_.squaredEdgeRatio * shortest) {
      const double ratio = longest / shortest, residual = kEdgeWeight * (ratio - limits_.squaredEdgeRatio);
      sum += residual * residual;
      if (withSlope) {
        const auto slopeOf = [&](double edge) {
          return edge == lq ? -2.0 * toQ : edge == lr ? -2.0 * toR : Point{0.0, 0.0};
        };
        add(residual, (kEdgeWeight / shortest) * (slopeOf(longest) - ratio * slopeOf(shortest)));
      }
    }
  }
  return sum;
}

template <bool withSlope>
double StarPenalty::lengths(Point hub) {
  double sum = 0.0;
  for (std::size_t k = 0; k < ring_.neighbours().size(); ++k) {
    const Point from = hub - ring_.at[k];
    const double scale = 1.0 / (wanted_[k] * wanted_[k]);
    const double part = squaredLength(from) * scale;
    const bool isLong = part > limits_.longest;
    if (!isLong && !(part < limits_.shortest)) continue;
    const double weight = isLong ? kLengthWeight : -kLengthWeight;
    const double residual = weight * (part - (isLong ? limits_.longest : limits_.shortest));
    sum += residual * residual;
    if (withSlope) add(residual, (2.0 * weight * scale) * from);
  }
  return sum;
}

template <bool withSlope>
double StarPenalty::pairs() {
  double sum = 0.0;
  const double most = limits_.areaRatio;
  const auto n = static_cast<std::size_t>(ring_.count);
  for (std::size_t k = 0; k < n; ++k) {
    const double own = area_[k], beyond = beyond_[k];
    if (beyond > 0.0 && own > most * beyond) {
      const double residual = kAreaWeight * (own / beyond - most);
      sum += residual * residual;
      if (withSlope) add(residual, (kAreaWeight / beyond) * areaSlope_[k]);
    } else if (beyond > most * own) {
      const double residual = kAreaWeight * (beyond / own - most);
      sum += residual * residual;
      if (withSlope) add(residual, (-kAreaWeight * beyond / (own * own)) * areaSlope_[k]);
    }
    const std::size_t next = k + 1 < n ? k + 1 : 0;
    if ((next == 0 && !ring_.closed) || next == k) break;
    const std::size_t large = area_[next] > own ? next : k, small = large == k ? next : k;
    if (!(area_[large] > most * area_[small])) continue;
    const double ratio = area_[large] / area_[small], residual = kAreaWeight * (ratio - most);
    sum += residual * residual;
    if (withSlope) add(residual, (kAreaWeight / area_[small]) * (areaSlope_[large] - ratio * areaSlope_[small]));
  }
  return sum;
}

}  // namespace triscope
