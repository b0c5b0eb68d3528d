#include "core/quality/quality.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "core/geometry/expansion.h"
#include "core/geometry/predicates.h"
#include "core/geometry/trig.h"
#include "core/mesh/edit.h"
#include "core/mesh/inside_box.h"
#include "core/mesh/mesh_changes.h"
#include "core/quality/quality_parts.h"

namespace triscope {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Angle at the apex in degrees, in [0, 180].
double angleAt(Point apex, Point a, Point b) {
  const double angle = trig::angleBetween(a - apex, b - apex);
  return (angle < 0.0 ? -angle : angle) / trig::kDegree;
}

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
constexpr double kClearlyApart = 1e-9;  // cosines this far apart are those of different angles

constexpr std::size_t kPart = 1024;  // slots

std::size_t partOf(Slot slot) { return static_cast<std::size_t>(slot.n) / kPart; }
std::size_t partsOf(const Mesh& mesh) { return (mesh.triangles.size() + kPart - 1) / kPart; }

void take(WorstSeen& seen, bool worse, const WorstSeen& candidate) {
  if (!seen.slot.exists() || worse || (candidate.value == seen.value && candidate.id < seen.id)) seen = candidate;
}
void takeLargest(WorstSeen& seen, const WorstSeen& candidate) { take(seen, candidate.value > seen.value, candidate); }
void takeSmallest(WorstSeen& seen, const WorstSeen& candidate) { take(seen, candidate.value < seen.value, candidate); }

void add(RunningSum& sum, double value) {
  const exact::Pair both = exact::twoSum(sum.total, value);
  sum.total = both.high;
  sum.lost += both.low;
}
double resultOf(const RunningSum& sum) { return sum.total + sum.lost; }

/// How many slots lie between two; far beyond them all when the second is the lower.
std::size_t between(Slot first, Slot slot) { return static_cast<std::size_t>(slot.n - first.n); }

/// The pairs that belong to a slot. `areas` are those of the slots from `first` on, -1 of those that do not count.
void addPairs(QualityPart& part, const Mesh& mesh, const InsideBox& inside, Slot slot, Slot first,
              const std::array<double, kPart>& areas) {
  const double here = areas[between(first, slot)];
  const TriangleId id = mesh.ids[slot];
  for (const Half across : mesh.triangles[slot].adj) {
    const Slot other = triangleOf(across);
    if (!across.exists() || other < slot) continue;  // no neighbour, or looked at from there
    const std::size_t place = between(first, other);
    const double there = place < areas.size() ? areas[place]
                         : inside.has(other)  ? 0.5 * std::fabs(twiceArea(mesh, other))
                                              : -1.0;
    if (there < 0.0) continue;
    const TriangleId otherId = mesh.ids[other];
    const bool hereFirst = here > there || (here == there && id < otherId);
    const double smaller = hereFirst ? there : here;
    takeLargest(part.areaRatio, {smaller > 0.0 ? (hereFirst ? here : there) / smaller : kInfinity,
                                 hereFirst ? id : otherId, hereFirst ? slot : other, hereFirst ? other : slot});
  }
}

QualityPart measurePart(const Mesh& mesh, const InsideBox& inside, std::size_t which) {
  QualityPart part;
  double smallest = -1.0, largest = 1.0;  // cosines of the smallest and of the largest angle so far
  const Slot end(std::min((which + 1) * kPart, mesh.triangles.size()));
  const Slot first(which * kPart);
  std::array<double, kPart> areas;
  areas.fill(-1.0);
  for (Slot slot = first; slot < end; ++slot) {
    if (!inside.has(slot)) continue;
    const auto& v = mesh.triangles[slot].v;
    TriangleSide sides[3];
    const TriangleQuality t = withoutAngles(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]], sides);
    const double ofSmallest = roughCosine(sides[1].squared, sides[2].squared, sides[0].squared);
    const double ofLargest = roughCosine(sides[0].squared, sides[1].squared, sides[2].squared);
    const TriangleId id = mesh.ids[slot];
    takeLargest(part.aspect, {t.aspect, id, slot, {}});
    takeLargest(part.edgeRatio, {t.edgeRatio, id, slot, {}});
    if (!(ofSmallest < smallest - kClearlyApart)) {
      takeSmallest(part.minAngle, {smallestAngle(sides), id, slot, {}});
      smallest = std::max(smallest, ofSmallest);
    }
    if (!(ofLargest > largest + kClearlyApart)) {
      takeLargest(part.maxAngle, {largestAngle(sides), id, slot, {}});
      largest = std::min(largest, ofLargest);
    }
    takeSmallest(part.minEdge, {t.shortest, id, slot, {}});
    add(part.area, t.area);
    add(part.aspects, t.aspect);
    ++part.triangles;
    if (t.obtuse) ++part.obtuse;
    areas[between(first, slot)] = std::fabs(t.area);
  }
  for (Slot slot = first; slot < end; ++slot)
    if (areas[between(first, slot)] >= 0.0) addPairs(part, mesh, inside, slot, first, areas);
  return part;
}

/// Whether some triangle that counts has this corner.
bool isUsed(const Mesh& mesh, const InsideBox& inside, Vertex vertex, Star& star) {
  const Slot slot = mesh.vertexTriangle[vertex];
  if (!slot.exists() || !mesh.alive(slot)) return false;
  if (!inside.boxed() || inside.has(slot)) return true;
  starOf(mesh, vertex, star);
  return std::any_of(star.rim.begin(), star.rim.end(), [&inside](Half half) { return inside.has(triangleOf(half)); });
}

void countVertices(const Mesh& mesh, const InsideBox& inside, Quality& q) {
  Star star;
  for (const Vertex v : mesh.points.keys()) {
    if (!isUsed(mesh, inside, v, star)) continue;
    ++q.vertices;
    if (mesh.vertexEdge[v].exists()) ++q.boundaryVertices;
  }
}

void add(QualityPart& sum, const QualityPart& part) {
  if (part.triangles == 0) return;
  sum.triangles += part.triangles;
  sum.obtuse += part.obtuse;
  takeLargest(sum.aspect, part.aspect);
  if (part.areaRatio.slot.exists()) takeLargest(sum.areaRatio, part.areaRatio);
  takeLargest(sum.edgeRatio, part.edgeRatio);
  takeSmallest(sum.minAngle, part.minAngle);
  takeLargest(sum.maxAngle, part.maxAngle);
  takeSmallest(sum.minEdge, part.minEdge);
  add(sum.area, part.area.total);
  sum.area.lost += part.area.lost;
  add(sum.aspects, part.aspects.total);
  sum.aspects.lost += part.aspects.lost;
}

Quality together(const Mesh& mesh, const InsideBox& inside, const std::vector<QualityPart>& parts) {
  QualityPart all;
  for (const QualityPart& part : parts) add(all, part);
  Quality q;
  countVertices(mesh, inside, q);
  q.triangles = all.triangles;
  q.obtuse = all.obtuse;
  if (q.triangles == 0) return q;
  q.aspectMax = all.aspect.value;
  q.aspectAt = all.aspect.slot;
  q.areaRatioMax = all.areaRatio.slot.exists() ? all.areaRatio.value : 1.0;
  q.areaRatioAt = all.areaRatio.slot;
  q.areaRatioOther = all.areaRatio.other;
  q.edgeRatioMax = all.edgeRatio.value;
  q.edgeRatioAt = all.edgeRatio.slot;
  q.minAngle = all.minAngle.value;
  q.minAngleAt = all.minAngle.slot;
  q.maxAngle = all.maxAngle.value;
  q.maxAngleAt = all.maxAngle.slot;
  q.minEdge = all.minEdge.value;
  q.minEdgeAt = all.minEdge.slot;
  q.area = resultOf(all.area);
  q.aspectMean = resultOf(all.aspects) / static_cast<double>(q.triangles);
  return q;
}

}  // namespace

TriangleQuality qualityOf(Point a, Point b, Point c) {
  TriangleSide sides[3];
  TriangleQuality q = withoutAngles(a, b, c, sides);
  q.minAngle = smallestAngle(sides);
  q.maxAngle = largestAngle(sides);
  return q;
}

TriangleQuality qualityOf(const Mesh& mesh, Slot slot) {
  const Triangle& t = triangleAt(mesh, slot);
  return qualityOf(pointOf(mesh, t.v[0]), pointOf(mesh, t.v[1]), pointOf(mesh, t.v[2]));
}

QualityInParts measureInParts(const Mesh& mesh) {
  const InsideBox inside(mesh);
  QualityInParts result;
  result.parts.resize(partsOf(mesh));
  for (std::size_t part = 0; part < result.parts.size(); ++part) result.parts[part] = measurePart(mesh, inside, part);
  result.quality = together(mesh, inside, result.parts);
  return result;
}

QualityInParts measureInParts(const Mesh& mesh, const Mesh& before, QualityInParts measured) {
  constexpr std::size_t kFew = 8;  // of so many triangles one: where more have changed, hardly a part stays as it is
  const auto changed = changedSlots(before, mesh, mesh.triangles.size() / kFew);
  if (!changed) return measureInParts(mesh);
  const InsideBox inside(mesh);
  std::vector<std::uint8_t> stale(partsOf(mesh), 0);
  for (const Slot slot : *changed) {
    stale[partOf(slot)] = 1;
    for (const Half across : triangleAt(mesh, slot).adj)
      if (across.exists() && mesh.triangles.has(triangleOf(across))) stale[partOf(triangleOf(across))] = 1;
  }
  const std::size_t known = std::min(measured.parts.size(), stale.size());
  // A part that was cut short, or goes on now, is another one.
  if (before.triangles.size() != mesh.triangles.size() && known > 0) stale[known - 1] = 1;
  measured.parts.resize(stale.size());
  for (std::size_t part = 0; part < stale.size(); ++part)
    if (stale[part] != 0 || part >= known) measured.parts[part] = measurePart(mesh, inside, part);
  measured.quality = together(mesh, inside, measured.parts);
  return measured;
}

Quality measure(const Mesh& mesh) { return measureInParts(mesh).quality; }

}  // namespace triscope
