#include "core/io/against_domain.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <tuple>

#include "core/base/index_text.h"
#include "core/base/shown_text.h"
#include "core/geometry/expansion.h"
#include "core/mesh/edit.h"

namespace triscope {
namespace {

constexpr double kTolerance = 1e-12;  // of the domain's size, or of its area

/// A sum of doubles with twice their precision.
class LongSum {
 public:
  void add(double value) {
    const exact::Pair sum = exact::twoSum(high_, value);
    high_ = sum.high;
    low_ += sum.low;
  }
  void addProduct(double a, double b) {
    const exact::Pair product = exact::twoProduct(a, b);
    add(product.high);
    low_ += product.low;
  }
  [[nodiscard]] double value() const { return high_ + low_; }

 private:
  double high_ = 0.0;
  double low_ = 0.0;
};

/// Twice the signed area of a closed polygon adds up from its edges.
void addEdge(LongSum& sum, Point a, Point b) {
  sum.addProduct(a.x, b.y);
  sum.addProduct(-b.x, a.y);
}

class DomainCheck {
 public:
  DomainCheck(const Mesh& mesh, const Domain& domain, std::size_t limit) : mesh_(mesh), domain_(domain), limit_(limit) {
    const double size = std::max(domain.bounds.width(), domain.bounds.height());
    const Box& box = domain.bounds;
    const double reach = std::max({std::fabs(box.lo.x), std::fabs(box.lo.y), std::fabs(box.hi.x), std::fabs(box.hi.y)});
    // Far from the origin a point on a line is rounded by more than its share of the domain's size.
    spacing_ = 0x1p-52 * reach;
    tolerance_ = std::max(kTolerance * size, 4.0 * spacing_);
    onBoundary_.assign(mesh.points.size(), 0);
    for (const Vertex v : mesh.points.keys()) {
      if (mesh.vertexTriangle[v].exists()) byPlace_.push_back(v);
    }
    std::sort(byPlace_.begin(), byPlace_.end(), [&](Vertex a, Vertex b) { return place(a) < place(b); });
  }

  std::vector<Violation> run() {
    const bool polygonal =
        std::ranges::all_of(domain_.curves, [](const Curve& c) { return c.kind == CurveKind::line; });
    for (const Loop& loop : domain_.loops) {
      for (std::uint32_t c = 0; c < loop.curveCount; ++c) checkCurve(loop, c);
    }
    if (polygonal) {
      if (found_.empty()) checkBorders();  // else they would say the same again
      checkArea();
    }
    return std::move(found_);
  }

 private:
  [[nodiscard]] std::tuple<double, double> place(Vertex v) const {
    const Point p = pointOf(mesh_, v);
    return {p.x + 0.0, p.y + 0.0};
  }
  void add(std::optional<Point> at, Vertex vertex, std::string message) {
    if (found_.size() < limit_) found_.push_back({Broken::domain, {}, vertex, at, std::move(message)});
  }

  [[nodiscard]] Vertex vertexAt(Point p) const {
    const std::tuple<double, double> wanted{p.x + 0.0, p.y + 0.0};
    const auto found = std::lower_bound(byPlace_.begin(), byPlace_.end(), wanted,
                                        [&](Vertex v, const auto& key) { return place(v) < key; });
    return found != byPlace_.end() && place(*found) == wanted ? *found : Vertex();
  }

  void checkCurve(const Loop& loop, std::uint32_t index) {
    const Curve& curve = domain_.curves[loop.firstCurve + index];
    const Vertex first = vertexAt(curve.a), last = vertexAt(curve.b);
    if (!first.exists()) {
      add(curve.a, {}, fmt::format("point {} of loop '{}' is no vertex of the mesh", index, shown(loop.name)));
    }
    // The end of a chain starts no other curve.
    if (!last.exists() && loop.role == LoopRole::chain && index + 1 == loop.curveCount) {
      add(curve.b, {}, fmt::format("point {} of loop '{}' is no vertex of the mesh", index + 1, shown(loop.name)));
    }
    if (!first.exists() || !last.exists() || curve.kind != CurveKind::line) return;
    for (Vertex v = first; v != last;) {
      onBoundary_[v] = 1;
      const Vertex next = nextAlong(curve, v, last);
      if (!next.exists()) {
        add(pointOf(mesh_, v), v,
            fmt::format("after point {} of loop '{}', no edge of the mesh follows the boundary from vertex {}", index,
                        shown(loop.name), v));
        return;
      }
      v = next;
    }
    onBoundary_[last] = 1;
  }

  /// The neighbour of v that lies on the straight curve and is next toward its end, if any.
  Vertex nextAlong(const Curve& curve, Vertex v, Vertex last) {
    const Point along = curve.b - curve.a;
    const double span = length(along);
    const double here = dot(pointOf(mesh_, v) - curve.a, along);
    double nearest = dot(along, along) * (1.0 + kTolerance);
    Vertex best;
    starOf(mesh_, v, star_);
    for (const Half half : star_.rim) {
      for (const Vertex other : {startOf(mesh_, half), endOf(mesh_, half)}) {
        if (other == last && findsEnd(curve, v)) return last;
        const Point offset = pointOf(mesh_, other) - curve.a;
        const double there = dot(offset, along);
        if (there <= here || there > nearest || std::fabs(cross(along, offset)) > tolerance_ * span) continue;
        nearest = there;
        best = other;
      }
    }
    return best;
  }
  /// The end of the curve itself counts whatever rounding says, unless v lies past it.
  [[nodiscard]] bool findsEnd(const Curve& curve, Vertex v) const {
    return dot(curve.b - pointOf(mesh_, v), curve.b - curve.a) > 0.0;
  }

  void checkBorders() {
    for (const Half half : halvesOf(mesh_)) {
      if (!mesh_.alive(triangleOf(half)) || oppositeOf(mesh_, half).exists()) continue;
      const Vertex v = startOf(mesh_, half);
      if (onBoundary_[v] != 0) continue;
      add(pointOf(mesh_, v), v, fmt::format("vertex {}: the mesh ends here, but not at the domain's boundary", v));
    }
  }

  void checkArea() {
    LongSum polygon, triangles;
    double perimeter = 0.0;
    for (const Loop& loop : domain_.loops) {
      if (loop.role == LoopRole::chain) continue;
      for (std::uint32_t c = 0; c < loop.curveCount; ++c) {
        const Curve& curve = domain_.curves[loop.firstCurve + c];
        addEdge(polygon, curve.a, curve.b);
        perimeter += distance(curve.a, curve.b);
      }
    }
    for (const Slot slot : mesh_.triangles.keys()) {
      if (!mesh_.alive(slot)) continue;
      for (int i = 0; i < 3; ++i)
        addEdge(triangles, pointOf(mesh_, startOf(mesh_, halfOf(slot, i))),
                pointOf(mesh_, endOf(mesh_, halfOf(slot, i))));
    }
    const double wanted = 0.5 * polygon.value(), found = 0.5 * triangles.value();
    if (!(std::fabs(found - wanted) <= std::max(kTolerance * wanted, spacing_ * perimeter))) {
      add({}, {},
          fmt::format("the mesh has the area {:.10g}, the domain {:.10g}: they differ by {:.1e} of it", found, wanted,
                      std::fabs(found - wanted) / wanted));
    }
  }

  const Mesh& mesh_;
  const Domain& domain_;
  std::size_t limit_;
  double spacing_ = 0.0;          // of coordinates where they are largest
  double tolerance_ = 0.0;        // distance from a line within which a point is on it
  std::vector<Vertex> byPlace_;   // vertices in use, by x then y
  Per<Vertex, char> onBoundary_;  // met on a straight piece
  Star star_;
  std::vector<Violation> found_;
};

}  // namespace

std::vector<Violation> checkAgainstDomain(const Mesh& mesh, const Domain& domain, std::size_t limit) {
  return DomainCheck(mesh, domain, limit).run();
}

}  // namespace triscope
