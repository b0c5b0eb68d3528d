#include "support/meshes.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "core/io/mesh_from.h"
#include "core/mesh/cavity.h"
#include "core/mesh/edit.h"
#include "core/mesh/locate.h"

namespace triscope::support {
namespace {

bool before(Point a, Point b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

template <class Less>
void startFromLeast(auto& corners, Less less) {
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end(), less), corners.end());
}

int incircleSign(const std::array<Point, 3>& t, Point d) {
  std::array<mpq_class, 3> x, y, lift;
  for (std::size_t i = 0; i < 3; ++i) {
    x[i] = mpq_class(t[i].x) - mpq_class(d.x);
    y[i] = mpq_class(t[i].y) - mpq_class(d.y);
    lift[i] = x[i] * x[i] + y[i] * y[i];
  }
  mpq_class det = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    det += lift[i] * (x[j] * y[k] - x[k] * y[j]);
  }
  return sgn(det);
}

std::vector<Point> scaled(std::vector<Point> points, double scale, Point by) {
  for (Point& p : points) p = scale * p + by;
  return points;
}

std::vector<Point> grid(int n) {
  std::vector<Point> points;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) points.push_back({static_cast<double>(i), static_cast<double>(j)});
  }
  return points;
}

// Whole-numbered points on the circle of radius 65 about the origin.
std::vector<Point> cocircular() {
  std::vector<Point> points;
  for (int x = -65; x <= 65; ++x) {
    for (int y = -65; y <= 65; ++y) {
      if (x * x + y * y == 65 * 65) points.push_back({static_cast<double>(x), static_cast<double>(y)});
    }
  }
  return points;
}

std::vector<Point> collinear(Point direction) {
  std::vector<Point> points;
  for (int k = 0; k < 25; ++k) points.push_back(static_cast<double>(k * 7 % 25) * direction);
  return points;
}

}  // namespace

Mesh meshOf(std::vector<Point> points, std::vector<std::array<int, 3>> triangles) {
  MeshFile file;
  file.points = std::move(points);
  file.triangles = std::move(triangles);
  const auto mesh = meshFrom(file);
  EXPECT_TRUE(mesh.ok());
  return *mesh;
}

Mesh boxMesh(Point lo, Point hi) {
  Mesh mesh;
  for (const Point corner : {lo, Point{hi.x, lo.y}, hi, Point{lo.x, hi.y}}) {
    addVertex(mesh, corner, VertexKind::kept, 1);
  }
  addTriangle(mesh, Vertex(0), Vertex(1), Vertex(2));
  addTriangle(mesh, Vertex(0), Vertex(2), Vertex(3));
  link(mesh, Half(1), Half(5));
  for (const int half : {2, 0, 3, 4}) constrain(mesh, Half(half));
  for (int side = 0; side < 4; ++side) {
    addBoundaryEdge(mesh, boundaryEdge(Vertex(side), Vertex((side + 1) % 4), static_cast<std::uint32_t>(side)));
  }
  return mesh;
}

Vertex insert(Mesh& mesh, Point p) {
  const Location location = walkTo(mesh, mesh.lastTriangle, p);
  EXPECT_FALSE(location.blocked.exists());
  for (const Vertex v : triangleAt(mesh, location.triangle).v) {
    if (pointOf(mesh, v) == p) return {};
  }
  Cavity cavity;
  findCavity(mesh, p, location.triangle, cavity);
  return fillCavity(mesh, cavity, VertexKind::steiner, 1);
}

Mesh triangulationOf(const std::vector<Point>& points) {
  Box box;
  for (const Point p : points) box.include(p);
  double margin = std::max(box.width(), box.height());
  if (!(margin > 0.0)) margin = 1.0;
  Mesh mesh = boxMesh(box.lo - Point{margin, margin}, box.hi + Point{margin, margin});
  for (const Point p : points) insert(mesh, p);
  return mesh;
}

std::vector<std::array<Vertex, 3>> trianglesOf(const Mesh& mesh) {
  std::vector<std::array<Vertex, 3>> all;
  for (const Slot slot : liveSlots(mesh)) {
    const auto& v = triangleAt(mesh, slot).v;
    all.push_back({v[0], v[1], v[2]});
    startFromLeast(all.back(), std::less<>());
  }
  std::ranges::sort(all);
  return all;
}

std::vector<std::array<Point, 3>> trianglesByPlace(const Mesh& mesh) {
  std::vector<std::array<Point, 3>> all;
  for (const Slot slot : liveSlots(mesh)) {
    const auto& v = triangleAt(mesh, slot).v;
    all.push_back({pointOf(mesh, v[0]), pointOf(mesh, v[1]), pointOf(mesh, v[2])});
    startFromLeast(all.back(), before);
  }
  std::ranges::sort(all,
                    [](const auto& l, const auto& r) { return std::ranges::lexicographical_compare(l, r, before); });
  return all;
}

std::vector<Slot> liveSlots(const Mesh& mesh) {
  std::vector<Slot> live;
  for (const Slot slot : mesh.triangles.keys()) {
    if (mesh.alive(slot)) live.push_back(slot);
  }
  return live;
}

std::string difference(const Mesh& a, const Mesh& b) {
  const auto sameTriangle = [](const Triangle& l, const Triangle& r) { return l.v == r.v && l.adj == r.adj; };
  const auto sameEdge = [](const BoundaryEdge& l, const BoundaryEdge& r) {
    return l.v0 == r.v0 && l.v1 == r.v1 && l.curve == r.curve && l.next0 == r.next0 && l.next1 == r.next1 &&
           l.t0 == r.t0 && l.t1 == r.t1;
  };
  if (a.points != b.points) return "points";
  if (a.kinds != b.kinds) return "kinds";
  if (a.density != b.density) return "density";
  if (a.vertexTriangle != b.vertexTriangle) return "vertexTriangle";
  if (a.vertexEdge != b.vertexEdge) return "vertexEdge";
  if (!std::ranges::equal(a.triangles, b.triangles, sameTriangle)) return "triangles";
  if (a.ids != b.ids) return "ids";
  if (a.flags != b.flags) return "flags";
  if (a.tested != b.tested) return "tested";
  if (a.freeSlots != b.freeSlots) return "freeSlots";
  if (!std::ranges::equal(a.edges, b.edges, sameEdge)) return "edges";
  if (a.nextId != b.nextId) return "nextId";
  if (a.lastTriangle != b.lastTriangle) return "lastTriangle";
  return "";
}

void expectDelaunayByBruteForce(const Mesh& mesh) {
  for (const Slot slot : liveSlots(mesh)) {
    const auto& v = triangleAt(mesh, slot).v;
    for (const Vertex vertex : mesh.points.keys()) {
      if (!mesh.vertexTriangle[vertex].exists() || vertex == v[0] || vertex == v[1] || vertex == v[2]) continue;
      ASSERT_LE(incircleSign({pointOf(mesh, v[0]), pointOf(mesh, v[1]), pointOf(mesh, v[2])}, mesh.points[vertex]), 0)
          << "vertex " << vertex << " lies inside the circle of " << v[0] << ", " << v[1] << ", " << v[2];
    }
  }
}

std::vector<PointSet> difficultPoints() {
  Random random{7};
  std::vector<Point> cluster = randomPoints(random, 20, {0, 0}, {1e-7, 1e-7});
  for (const Point p : randomPoints(random, 20, {0, 0}, {1, 1})) cluster.push_back(p);
  std::vector<Point> repeated = grid(4);
  for (const Point p : grid(4)) repeated.push_back(p);
  return {
      {"random", randomPoints(random, 60, {0, 0}, {1, 1})},
      {"grid", grid(7)},
      {"grid_tiny", scaled(grid(6), 1e-9, {0, 0})},
      {"grid_of_tenths", scaled(grid(6), 0.1, {0.3, 0.7})},
      {"grid_far_away", scaled(grid(6), 0.1, {4e7, -4e7})},
      {"random_far_away", scaled(randomPoints(random, 50, {0, 0}, {1, 1}), 1e-3, {4e7, 4e7})},
      {"cocircular", cocircular()},
      {"cocircular_with_centre", scaled(cocircular(), 1.0 / 65.0, {1.0 / 3.0, 0})},
      {"collinear", collinear({1, 0})},
      {"collinear_aslant", collinear({0.1, 0.3})},
      {"cluster", cluster},
      {"repeated", repeated},
      {"two", {{0.25, 0.25}, {0.75, 0.5}}},
  };
}

std::vector<Point> randomPoints(Random& random, std::size_t count, Point lo, Point hi) {
  std::vector<Point> points;
  for (std::size_t k = 0; k < count; ++k) points.push_back({random.between(lo.x, hi.x), random.between(lo.y, hi.y)});
  return points;
}

}  // namespace triscope::support
