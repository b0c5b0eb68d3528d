#include "core/density/boundary_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "core/geometry/predicates.h"

namespace triscope {
namespace {

constexpr std::uint32_t kLeafSize = 4;

// Splits the longer side at the median.
void build(BoundaryTree& tree, std::uint32_t node, std::uint32_t first, std::uint32_t count) {
  Box box;
  for (std::uint32_t k = first; k < first + count; ++k) {
    box.include(tree.pieces[k].a);
    box.include(tree.pieces[k].b);
  }
  tree.nodes[node].box = box;
  if (count <= kLeafSize) {
    tree.nodes[node].first = first;
    tree.nodes[node].count = count;
    return;
  }
  const bool byX = box.width() >= box.height();
  const auto before = [byX](const BoundaryPiece& l, const BoundaryPiece& r) {
    const double left = byX ? l.a.x + l.b.x : l.a.y + l.b.y;
    const double right = byX ? r.a.x + r.b.x : r.a.y + r.b.y;
    if (left != right) return left < right;
    return std::tie(l.curve, l.a.x, l.a.y) < std::tie(r.curve, r.a.x, r.a.y);
  };
  const auto begin = tree.pieces.begin() + first;
  std::nth_element(begin, begin + count / 2, begin + count, before);
  const auto children = static_cast<std::uint32_t>(tree.nodes.size());
  tree.nodes[node].first = children;
  tree.nodes[node].count = 0;
  tree.nodes.resize(tree.nodes.size() + 2);
  build(tree, children, first, count / 2);
  build(tree, children + 1, first + count / 2, count - count / 2);
}

void cut(const Curve& curve, std::uint32_t index, bool twoSided, double turn, BoundaryTree& tree) {
  if (curve.kind == CurveKind::line) {
    tree.pieces.push_back({curve.a, curve.b, index, twoSided});
    return;
  }
  const double total = lengthBetween(curve, 0.0, 1.0);
  double t = 0.0;
  Point from = curve.a;
  while (t < 1.0) {
    const double bend = curvatureAt(curve, t);
    const double step = std::min(total / 8.0, bend > 0.0 ? std::max(turn / bend, total * 1e-4) : total);
    double next = t + step / std::max(length(derivativeAt(curve, t)), total * 1e-6);
    if (next > 1.0 - 1e-9) next = 1.0;
    const Point to = next == 1.0 ? curve.b : pointAt(curve, next);
    tree.pieces.push_back({from, to, index, twoSided});
    from = to;
    t = next;
  }
}

bool rayMeetsBox(Point origin, Point direction, const Box& box, double within) {
  double lo = 0.0;
  double hi = within;
  const std::array<double, 2> o{origin.x, origin.y}, d{direction.x, direction.y};
  const std::array<double, 2> low{box.lo.x, box.lo.y}, high{box.hi.x, box.hi.y};
  for (std::size_t k = 0; k < 2; ++k) {
    if (d[k] == 0.0) {
      if (o[k] < low[k] || o[k] > high[k]) return false;
      continue;
    }
    const double s = (low[k] - o[k]) / d[k];
    const double e = (high[k] - o[k]) / d[k];
    lo = std::max(lo, std::min(s, e));
    hi = std::min(hi, std::max(s, e));
  }
  return lo <= hi;
}

double squaredDistanceTo(const Box& box, Point p) {
  const Point d{std::max({box.lo.x - p.x, 0.0, p.x - box.hi.x}), std::max({box.lo.y - p.y, 0.0, p.y - box.hi.y})};
  return dot(d, d);
}

bool contains(const Cone& cone, Point p) {
  const Point d = p - cone.apex;
  return cross(cone.first, d) <= 0.0 && cross(d, cone.last) <= 0.0;
}

bool touch(const Curve& l, const Curve& r) { return l.a == r.b || l.b == r.a || l.a == r.a || l.b == r.b; }

// Calls visit(piece index) for the pieces of every leaf whose box `wanted` accepts.
template <class Wanted, class Visit>
void descend(const BoundaryTree& tree, const Wanted& wanted, const Visit& visit) {
  std::array<std::uint32_t, 128> stack{};  // the tree halves its pieces: deeper than 64 cannot be
  std::size_t depth = 0;
  if (!tree.nodes.empty()) stack[depth++] = 0;
  while (depth > 0) {
    const BoundaryTree::Node& node = tree.nodes[stack[--depth]];
    if (!wanted(node.box)) continue;
    if (node.count == 0) {
      stack[depth++] = node.first;
      stack[depth++] = node.first + 1;
    }
    for (std::uint32_t k = node.first; k < node.first + node.count; ++k) visit(k);
  }
}

}  // namespace

BoundaryTree boundaryTreeOf(const Domain& domain, double turn) {
  BoundaryTree tree;
  for (const Loop& loop : domain.loops) {
    for (std::uint32_t c = loop.firstCurve; c < loop.firstCurve + loop.curveCount; ++c) {
      cut(domain.curves[c], c, loop.role == LoopRole::chain, turn, tree);
    }
  }
  if (!tree.pieces.empty()) {
    tree.nodes.resize(1);
    build(tree, 0, 0, static_cast<std::uint32_t>(tree.pieces.size()));
  }
  return tree;
}

RayHit castRay(const BoundaryTree& tree, const Domain& domain, Point origin, Point direction, std::uint32_t own) {
  RayHit hit;
  const Curve& from = domain.curves[own];
  const auto wanted = [&](const Box& box) { return rayMeetsBox(origin, direction, box, hit.distance); };
  descend(tree, wanted, [&](std::uint32_t k) {
    const BoundaryPiece& piece = tree.pieces[k];
    if (piece.curve == own ? from.kind == CurveKind::line : touch(from, domain.curves[piece.curve])) return;
    const Point edge = piece.b - piece.a;
    const double across = cross(direction, edge);
    if (across == 0.0) return;
    const double s = cross(piece.a - origin, edge) / across;
    const double u = cross(piece.a - origin, direction) / across;
    if (s > 0.0 && u >= 0.0 && u <= 1.0 && s < hit.distance) hit = {s, k};
  });
  return hit;
}

Nearest nearestIn(const BoundaryTree& tree, const Domain& domain, const Cone& cone) {
  Nearest nearest;
  double least = 1e300;
  const auto offer = [&](Point p, std::uint32_t piece) {
    const double d = squaredDistance(cone.apex, p);
    if (d > least || (d == least && piece >= nearest.piece)) return;
    least = d;
    nearest = {std::sqrt(d), p, piece};
  };
  const auto wanted = [&](const Box& box) { return squaredDistanceTo(box, cone.apex) <= least; };
  descend(tree, wanted, [&](std::uint32_t k) {
    const BoundaryPiece& piece = tree.pieces[k];
    const Curve& curve = domain.curves[piece.curve];
    if (curve.a == cone.apex || curve.b == cone.apex) return;
    const Point edge = piece.b - piece.a;
    const double along = dot(cone.apex - piece.a, edge) / dot(edge, edge);
    for (const Point p : {piece.a + std::clamp(along, 0.0, 1.0) * edge, piece.a, piece.b})
      if (contains(cone, p)) offer(p, k);
    // Where a side of the cone crosses the piece.
    for (const Point side : {cone.first, cone.last}) {
      const double across = cross(side, edge);
      if (across == 0.0) continue;
      const double s = cross(piece.a - cone.apex, edge) / across;
      const double u = cross(piece.a - cone.apex, side) / across;
      if (s > 0.0 && u >= 0.0 && u <= 1.0) offer(piece.a + u * edge, k);
    }
  });
  return nearest;
}

bool insideDomain(const BoundaryTree& tree, Point p) {
  bool inside = false;
  const auto wanted = [p](const Box& box) { return box.lo.y <= p.y && box.hi.y >= p.y && box.hi.x >= p.x; };
  descend(tree, wanted, [&](std::uint32_t k) {
    const BoundaryPiece& piece = tree.pieces[k];
    if (piece.twoSided || (piece.a.y > p.y) == (piece.b.y > p.y)) return;
    const int side = piece.b.y > piece.a.y ? orient2d(piece.a, piece.b, p) : orient2d(piece.b, piece.a, p);
    if (side > 0) inside = !inside;  // p lies to the left of the upward edge: the ray to the right meets it
  });
  return inside;
}

}  // namespace triscope
