#include "support/judge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/density/boundary_tree.h"
#include "core/domain/loop_of.h"
#include "core/domain/shortest_line.h"
#include "core/io/against_domain.h"
#include "core/mesh/edit.h"
#include "core/mesh/validate.h"
#include "core/quality/quality.h"
#include "support/ids.h"
#include "support/segment.h"

namespace triscope::support {
namespace {

struct Sum {
  long double value = 0.0L;
  long double lost = 0.0L;

  // Neumaier's compensated sum.
  void add(long double term) {
    const long double next = value + term;
    lost += std::fabs(value) >= std::fabs(term) ? (value - next) + term : (term - next) + value;
    value = next;
  }
};

long double cross(Point about, Point a, Point b) {
  const long double ax = static_cast<long double>(a.x) - about.x, ay = static_cast<long double>(a.y) - about.y;
  const long double bx = static_cast<long double>(b.x) - about.x, by = static_cast<long double>(b.y) - about.y;
  return ax * by - ay * bx;
}

bool ofLines(const Domain& domain) {
  return std::ranges::all_of(domain.curves, [](const Curve& c) { return c.kind == CurveKind::line; });
}

bool touch(const Curve& l, const Curve& r) { return l.a == r.b || l.b == r.a || l.a == r.a || l.b == r.b; }

void expectKeptPoints(const MeshState& state) {
  std::map<std::pair<double, double>, VertexKind> kinds;
  for (const Vertex v : state.mesh.points.keys()) {
    if (state.mesh.vertexTriangle[v].exists())
      kinds[{state.mesh.points[v].x, state.mesh.points[v].y}] = state.mesh.kinds[v];
  }
  for (const Curve& curve : state.domain->curves) {
    for (const Point p : {curve.a, curve.b}) {
      const auto found = kinds.find({p.x, p.y});
      ASSERT_NE(found, kinds.end()) << "no vertex at the kept point " << p.x << ", " << p.y;
      EXPECT_EQ(found->second, VertexKind::kept) << p.x << ", " << p.y;
    }
  }
}

void expectCurvesFollowed(const MeshState& state) {
  const Mesh& mesh = state.mesh;
  const Domain& domain = *state.domain;
  std::vector<BoundaryEdge> edges = mesh.edges;
  std::erase_if(edges, [](const BoundaryEdge& edge) { return !exists(edge); });
  std::ranges::sort(edges, [](const BoundaryEdge& l, const BoundaryEdge& r) {
    return l.curve != r.curve ? l.curve < r.curve : l.t0 < r.t0;
  });
  const double reach = std::max({std::fabs(domain.bounds.lo.x), std::fabs(domain.bounds.lo.y),
                                 std::fabs(domain.bounds.hi.x), std::fabs(domain.bounds.hi.y)});
  const double tolerance = 1e-15 * reach;
  std::size_t k = 0;
  for (std::uint32_t c = 0; c < domain.curves.size(); ++c) {
    double t = 0.0;
    Vertex vertex;
    for (; k < edges.size() && edges[k].curve == c; ++k) {
      const BoundaryEdge& edge = edges[k];
      ASSERT_EQ(edge.t0, t) << "a gap in the edges along curve " << c;
      if (vertex.exists()) {
        ASSERT_EQ(edge.v0, vertex) << "curve " << c << " at " << t;
      }
      const Half half = findHalfEdge(mesh, edge.v0, edge.v1);
      ASSERT_TRUE(half.exists()) << "curve " << c << " has no edge from " << edge.t0 << " to " << edge.t1;
      EXPECT_TRUE(constrained(mesh, half));
      EXPECT_EQ(oppositeOf(mesh, half).exists(), loopOf(domain, c).role == LoopRole::chain);
      EXPECT_LE(distance(pointOf(mesh, edge.v0), pointAt(domain.curves[c], edge.t0)), tolerance);
      t = edge.t1;
      vertex = edge.v1;
    }
    ASSERT_EQ(t, 1.0) << "curve " << c << " is not followed to its end";
  }
  EXPECT_EQ(k, edges.size());
}

}  // namespace

void expectBounds(const MeshState& state) {
  const Quality q = measure(state.mesh);
  EXPECT_LT(q.aspectMax, Bounds::aspect);
  EXPECT_LT(q.areaRatioMax, Bounds::areaRatio);
  EXPECT_LT(q.edgeRatioMax, Bounds::edgeRatio);
  EXPECT_GT(q.minAngle, Bounds::minAngle);
  EXPECT_LT(q.maxAngle, Bounds::maxAngle);
  EXPECT_TRUE(q.withinBounds());
}

void expectValid(const Mesh& mesh) {
  for (const Violation& violation : validate(mesh)) ADD_FAILURE() << violation.message;
  for (const Slot slot : mesh.flags.keys()) {
    ASSERT_EQ(mesh.flags[slot] & kInCavity, 0) << "a mark was left on slot " << slot;
  }
}

void expectFollowsDomain(const MeshState& state, double areaTolerance) {
  ASSERT_FALSE(state.failed);
  expectKeptPoints(state);
  expectCurvesFollowed(state);
  for (const Violation& violation : checkAgainstDomain(state.mesh, *state.domain)) ADD_FAILURE() << violation.message;
  if (!ofLines(*state.domain)) return;
  const long double area = areaOf(*state.domain);
  EXPECT_LT(std::fabs(areaOf(state) - area), std::max(1e-12, areaTolerance) * area)
      << "area " << static_cast<double>(area);
}

void expectNoShortEdge(const MeshState& state, double part) {
  if (state.minEdgeDerived) return;
  const double floor = part * std::min(state.minEdge, shortestUnavoidableEdge(*state.domain));
  EXPECT_GE(measure(state.mesh).minEdge, floor * (1.0 - 1e-9));
}

long double areaOf(const MeshState& state) {
  Sum sum;
  const Point about = state.domain->bounds.lo;
  for (const Slot slot : state.mesh.triangles.keys()) {
    if ((state.mesh.flags[slot] & kDead) != 0) continue;
    const auto& v = state.mesh.triangles[slot].v;
    for (std::size_t i = 0; i < 3; ++i) {
      sum.add(0.5L * cross(about, pointOf(state.mesh, v[i]), pointOf(state.mesh, v[(i + 1) % 3])));
    }
  }
  return sum.value + sum.lost;
}

long double areaOf(const Domain& domain) {
  Sum sum;
  for (std::uint32_t c = 0; c < domain.curves.size(); ++c) {
    if (loopOf(domain, c).role != LoopRole::chain)
      sum.add(0.5L * cross(domain.bounds.lo, domain.curves[c].a, domain.curves[c].b));
  }
  return sum.value + sum.lost;
}

double shortestUnavoidableEdge(const Domain& domain) {
  double shortest = shortestLine(domain).length;
  for (const Loop& loop : domain.loops) {
    if (loop.role == LoopRole::chain || loop.curveCount > 1) continue;
    // The chord of a sixth of a circle is 3/π of its arc.
    shortest = std::min(shortest, 0.95 / 6.0 * lengthBetween(domain.curves[loop.firstCurve], 0.0, 1.0));
  }
  const std::vector<BoundaryPiece> pieces = boundaryTreeOf(domain, 0.1).pieces;
  for (const BoundaryPiece& piece : pieces) {
    for (const BoundaryPiece& other : pieces) {
      if (!touch(domain.curves[piece.curve], domain.curves[other.curve])) {
        shortest = std::min(shortest, distanceToSegment(piece.a, other.a, other.b));
      }
    }
  }
  return shortest;
}

}  // namespace triscope::support
