#include "core/quality/quality.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/geometry/expansion.h"
#include "core/geometry/predicates.h"
#include "core/geometry/trig.h"
#include "core/mesh/edit.h"

namespace triscope {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Angle at the apex in degrees, in [0, 180].
double angleAt(Point apex, Point a, Point b) {
  const double angle = trig::angleBetween(a - apex, b - apex);
  return (angle < 0.0 ? -angle : angle) / trig::kDegree;
}

/// The worst value seen and where; equal values go to the lowest id, whatever the order of the slots.
struct WorstFigure {
  double value = 0.0;
  std::uint32_t id = 0;
  std::int32_t slot = -1;
  std::int32_t other = -1;

  void take(bool worse, const WorstFigure& candidate) {
    if (slot == -1 || worse || (candidate.value == value && candidate.id < id)) *this = candidate;
  }
  void takeLargest(const WorstFigure& candidate) { take(candidate.value > value, candidate); }
  void takeSmallest(const WorstFigure& candidate) { take(candidate.value < value, candidate); }
};

/// A running sum that keeps what each addition rounds away.
struct Sum {
  double total = 0.0;
  double lost = 0.0;
  void add(double value) {
    const exact::Pair sum = exact::twoSum(total, value);
    total = sum.high;
    lost += sum.low;
  }
  [[nodiscard]] double result() const { return total + lost; }
};

struct TriangleSide {
  double squared;
  Point opposite;
};

// All but the angles. Sides shortest first: the first corner lies opposite the shortest edge, the last opposite the
// longest.
TriangleQuality withoutAngles(Point a, Point b, Point c, TriangleSide (&sides)[3]) {
  sides[0] = {squaredDistance(b, c), a};
  sides[1] = {squaredDistance(c, a), b};
  sides[2] = {squaredDistance(a, b), c};
  if (sides[1].squared < sides[0].squared) std::swap(sides[0], sides[1]);
  if (sides[2].squared < sides[1].squared) std::swap(sides[1], sides[2]);
  if (sides[1].squared < sides[0].squared) std::swap(sides[0], sides[1]);
  const double shortest = std::sqrt(sides[0].squared);
  const double middle = std::sqrt(sides[1].squared);
  const double longest = std::sqrt(sides[2].squared);

  TriangleQuality q;
  q.shortest = shortest;
  q.longest = longest;
  q.area = 0.5 * cross(b - a, c - a);
  const double area = std::fabs(q.area);
  const double perimeter = shortest + middle + longest;
  q.inradius = perimeter > 0.0 ? 2.0 * area / perimeter : 0.0;
  q.circumradius = area > 0.0 ? shortest * middle * longest / (4.0 * area) : kInfinity;
  q.aspect = area > 0.0 ? q.circumradius / q.inradius : kInfinity;
  q.edgeRatio = shortest > 0.0 ? longest / shortest : kInfinity;
  q.obtuse = dotSign(sides[2].opposite, sides[0].opposite, sides[1].opposite) < 0;
  return q;
}

double smallestAngle(const TriangleSide (&sides)[3]) {
  return angleAt(sides[0].opposite, sides[1].opposite, sides[2].opposite);
}
double largestAngle(const TriangleSide (&sides)[3]) {
  return angleAt(sides[2].opposite, sides[0].opposite, sides[1].opposite);
}

// Cosine of the angle between two sides, by their squares and that of the third: to see which angles are worth an arc
// tangent. Not a number, as anything compared with it is false, for a side without length.
double roughCosine(double left, double right, double opposite) {
  return (left + right - opposite) / (2.0 * std::sqrt(left * right));
}
constexpr double kClearly = 1e-9;  // cosines this far apart are those of different angles

}  // namespace

TriangleQuality qualityOf(Point a, Point b, Point c) {
  TriangleSide sides[3];
  TriangleQuality q = withoutAngles(a, b, c, sides);
  q.minAngle = smallestAngle(sides);
  q.maxAngle = largestAngle(sides);
  return q;
}

Quality measure(const Mesh& mesh) {
  Quality q;
  WorstFigure aspect, areaRatio, edgeRatio, minAngle, maxAngle, minEdge;
  Sum area, aspects;
  double smallest = -1.0, largest = 1.0;  // cosines of the smallest and of the largest angle so far
  std::vector<char> used(mesh.points.size(), 0);
  const auto slots = static_cast<std::int32_t>(mesh.triangles.size());

  std::vector<double> areas(mesh.triangles.size(), -1.0);  // -1: not measured
  for (std::int32_t slot = 0; slot < slots; ++slot) {
    const auto index = at(slot);
    if (!mesh.alive(slot) || touchesHelper(mesh, slot)) continue;
    const auto& v = mesh.triangles[index].v;
    for (const std::int32_t corner : v) used[at(corner)] = 1;
    TriangleSide sides[3];
    const TriangleQuality t = withoutAngles(mesh.points[at(v[0])], mesh.points[at(v[1])], mesh.points[at(v[2])], sides);
    const double ofSmallest = roughCosine(sides[1].squared, sides[2].squared, sides[0].squared);
    const double ofLargest = roughCosine(sides[0].squared, sides[1].squared, sides[2].squared);
    const std::uint32_t id = mesh.ids[index];
    aspect.takeLargest({t.aspect, id, slot});
    edgeRatio.takeLargest({t.edgeRatio, id, slot});
    if (!(ofSmallest < smallest - kClearly)) {
      minAngle.takeSmallest({smallestAngle(sides), id, slot});
      smallest = std::max(smallest, ofSmallest);
    }
    if (!(ofLargest > largest + kClearly)) {
      maxAngle.takeLargest({largestAngle(sides), id, slot});
      largest = std::min(largest, ofLargest);
    }
    minEdge.takeSmallest({t.shortest, id, slot});
    area.add(t.area);
    aspects.add(t.aspect);
    areas[index] = std::fabs(t.area);
    ++q.triangles;
    if (t.obtuse) ++q.obtuse;
  }

  for (std::int32_t slot = 0; slot < slots; ++slot) {
    const double here = areas[at(slot)];
    if (here < 0.0) continue;
    for (const std::int32_t across : mesh.triangles[at(slot)].adj) {
      const std::int32_t other = across / 3;
      if (across < 0 || other < slot) continue;  // no neighbour, or the pair was looked at from there
      const double there = areas[at(other)];
      if (there < 0.0) continue;
      const std::uint32_t id = mesh.ids[at(slot)];
      const std::uint32_t otherId = mesh.ids[at(other)];
      const bool hereFirst = here > there || (here == there && id < otherId);
      const double smaller = hereFirst ? there : here;
      areaRatio.takeLargest({smaller > 0.0 ? (hereFirst ? here : there) / smaller : kInfinity, hereFirst ? id : otherId,
                             hereFirst ? slot : other, hereFirst ? other : slot});
    }
  }

  for (std::size_t v = 0; v < used.size(); ++v) {
    if (used[v] == 0) continue;
    ++q.vertices;
    if (mesh.vertexEdge[v] != -1) ++q.boundaryVertices;
  }
  if (q.triangles == 0) return q;

  q.aspectMax = aspect.value;
  q.aspectAt = aspect.slot;
  q.areaRatioMax = areaRatio.slot >= 0 ? areaRatio.value : 1.0;
  q.areaRatioAt = areaRatio.slot;
  q.areaRatioOther = areaRatio.other;
  q.edgeRatioMax = edgeRatio.value;
  q.edgeRatioAt = edgeRatio.slot;
  q.minAngle = minAngle.value;
  q.minAngleAt = minAngle.slot;
  q.maxAngle = maxAngle.value;
  q.maxAngleAt = maxAngle.slot;
  q.minEdge = minEdge.value;
  q.minEdgeAt = minEdge.slot;
  q.area = area.result();
  q.aspectMean = aspects.result() / static_cast<double>(q.triangles);
  return q;
}

}  // namespace triscope
