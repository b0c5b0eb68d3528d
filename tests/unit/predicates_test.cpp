// The predicates against exact rational arithmetic (GMP) and against recorded cases.
#include "core/geometry/predicates.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "core/geometry/circumcircle.h"

namespace triscope::predicates_test {
namespace {

int orient2dOracle(Point a, Point b, Point c) {
  const mpq_class ax(a.x), ay(a.y), bx(b.x), by(b.y), cx(c.x), cy(c.y);
  return sgn((ax - cx) * (by - cy) - (ay - cy) * (bx - cx));
}

int dotSignOracle(Point apex, Point a, Point b) {
  const mpq_class x(apex.x), y(apex.y);
  return sgn((mpq_class(a.x) - x) * (mpq_class(b.x) - x) + (mpq_class(a.y) - y) * (mpq_class(b.y) - y));
}

int incircleOracle(Point a, Point b, Point c, Point d) {
  const mpq_class dx(d.x), dy(d.y);
  const mpq_class ax = a.x - dx, ay = a.y - dy, bx = b.x - dx, by = b.y - dy, cx = c.x - dx, cy = c.y - dy;
  return sgn((ax * ax + ay * ay) * (bx * cy - cx * by) + (bx * bx + by * by) * (cx * ay - ax * cy) +
             (cx * cx + cy * cy) * (ax * by - bx * ay));
}

std::string text(std::initializer_list<Point> points) {
  std::string out;
  char buffer[80];
  for (const Point p : points) {
    std::snprintf(buffer, sizeof buffer, "(%a, %a) ", p.x, p.y);
    out += buffer;
  }
  return out;
}

void expectOrient2d(Point a, Point b, Point c) {
  const int sign = orient2dOracle(a, b, c);
  EXPECT_EQ(orient2d(a, b, c), sign) << text({a, b, c});
  EXPECT_EQ(orient2d(b, c, a), sign) << text({a, b, c});
  EXPECT_EQ(orient2d(b, a, c), -sign) << text({a, b, c});
  EXPECT_EQ(detail::orient2dExact(a, b, c), sign) << text({a, b, c});
}

void expectDotSign(Point apex, Point a, Point b) {
  const int sign = dotSignOracle(apex, a, b);
  EXPECT_EQ(dotSign(apex, a, b), sign) << text({apex, a, b});
  EXPECT_EQ(dotSign(apex, b, a), sign) << text({apex, a, b});
  EXPECT_EQ(detail::dotSignExact(apex, a, b), sign) << text({apex, a, b});
}

void expectIncircle(Point a, Point b, Point c, Point d) {
  const int sign = incircleOracle(a, b, c, d);
  EXPECT_EQ(incircle(a, b, c, d), sign) << text({a, b, c, d});
  EXPECT_EQ(incircle(c, a, b, d), sign) << text({a, b, c, d});
  EXPECT_EQ(incircle(b, a, c, d), -sign) << text({a, b, c, d});
  EXPECT_EQ(incircle(a, b, d, c), -sign) << text({a, b, c, d});
  EXPECT_EQ(detail::incircleExact(a, b, c, d), sign) << text({a, b, c, d});
}

/// The places where meshing goes wrong: around zero, far away, and very small.
const std::vector<std::pair<Point, double>>& frames() {
  static const std::vector<std::pair<Point, double>> list = {
      {{0.0, 0.0}, 1.0},     {{0.0, 0.0}, 0.1},         {{4e7, 4e7}, 1.0},      {{4e7, -3.9e7}, 0.1},
      {{0.0, 0.0}, 1e-9},    {{1e-9, -2e-9}, 3e-10},    {{0.5, 0.5}, 1e-15},    {{1e30, 1e-30}, 1e29},
      {{0.0, 0.0}, 0x1p-60}, {{1.0 / 3, 2.0 / 3}, 0.3}, {{1e6, 1e-6}, 1.0 / 7},
  };
  return list;
}

TEST(Predicates, EveryTripleOfASmallGrid) {
  for (const auto& [origin, step] : frames()) {
    std::vector<Point> grid;
    for (int x = 0; x < 4; ++x)
      for (int y = 0; y < 4; ++y) grid.push_back(origin + Point{x * step, y * step});
    for (const Point a : grid)
      for (const Point b : grid)
        for (const Point c : grid) {
          expectOrient2d(a, b, c);
          expectDotSign(a, b, c);
        }
  }
}

TEST(Predicates, EveryQuadrupleOfASmallGrid) {
  for (const auto& [origin, step] : frames()) {
    std::vector<Point> grid;
    for (int x = 0; x < 3; ++x)
      for (int y = 0; y < 3; ++y) grid.push_back(origin + Point{x * step, y * step});
    for (std::size_t a = 0; a < 9; ++a)
      for (std::size_t b = 0; b < 9; ++b)
        for (std::size_t c = 0; c < 9; ++c)
          for (std::size_t d = 0; d <= c; ++d) expectIncircle(grid[a], grid[b], grid[c], grid[d]);
  }
}

/// Integer points on one circle about the origin.
std::vector<Point> circlePoints(double scale) {
  std::vector<Point> points;
  for (const auto& [x, y] : std::array<std::array<double, 2>, 9>{
           {{65, 0}, {63, 16}, {60, 25}, {56, 33}, {52, 39}, {39, 52}, {33, 56}, {25, 60}, {16, 63}}}) {
    for (const double sx : {-1.0, 1.0})
      for (const double sy : {-1.0, 1.0}) points.push_back({sx * x * scale, sy * y * scale});
  }
  return points;
}

/// The next double up; a small one above zero, as the predicates leave out the smallest doubles.
double nudged(double value) { return value == 0.0 ? 1e-60 : std::nextafter(value, 1e300); }

TEST(Predicates, CocircularPointsAndTheirNeighbours) {
  std::mt19937_64 random(7);
  for (const double scale : {1.0, 0x1p22, 0x1.fffffp22, 0x1.fffffffffp10, 1e-9, 1e-11, 0.1, 6e5, 1e28}) {
    for (const Point centre : {Point{0, 0}, Point{4e7, -4e7}, Point{1e-9, 1e-9}, Point{1.0 / 3, 1e3}}) {
      const auto points = circlePoints(scale);
      for (int i = 0; i < 60; ++i) {
        std::array<Point, 4> p;
        for (Point& q : p) q = centre + points[random() % points.size()];
        expectIncircle(p[0], p[1], p[2], p[3]);
        p[0].x = nudged(p[0].x);
        expectIncircle(p[0], p[1], p[2], p[3]);
        p[3].y = nudged(p[3].y);
        expectIncircle(p[0], p[1], p[2], p[3]);
      }
    }
  }
}

TEST(Predicates, RectanglesWithLongMantissas) {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int i = 0; i < 500; ++i) {
    const Point lo{uniform(random), uniform(random) * 1e-3}, hi{uniform(random) * 1e3, uniform(random)};
    ASSERT_EQ(incircle(lo, {hi.x, lo.y}, hi, {lo.x, hi.y}), 0);
    expectIncircle(lo, {hi.x, lo.y}, hi, {std::nextafter(lo.x, 9.0), hi.y});
  }
}

TEST(Predicates, CollinearPointsAndTheirNeighbours) {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (const auto& [origin, step] : frames()) {
    for (int i = 0; i < 300; ++i) {
      const Point a = origin + Point{uniform(random) * step, uniform(random) * step};
      const Point along{uniform(random) * step, uniform(random) * step};
      const Point b = a + along;
      Point c = a + static_cast<double>(random() % 64) * along;
      expectOrient2d(a, b, c);
      c.x = nudged(c.x);
      expectOrient2d(a, b, c);
    }
  }
}

TEST(Predicates, RightAnglesAndTheirNeighbours) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (const auto& [origin, step] : frames()) {
    for (int i = 0; i < 300; ++i) {
      const Point arm{uniform(random) * step, uniform(random) * step};
      const Point a = origin + arm, b = origin + perpendicular(arm);
      expectDotSign(origin, a, b);
      expectDotSign(origin, {nudged(a.x), a.y}, b);
      expectDotSign(b, a, origin);
    }
  }
}

TEST(Predicates, MixedMagnitudes) {
  std::mt19937_64 random(10);
  std::uniform_real_distribution<double> mantissa(-1.0, 1.0);
  std::uniform_int_distribution<int> exponent(-190, 190);
  const auto coordinate = [&] { return std::ldexp(mantissa(random), exponent(random)); };
  for (int i = 0; i < 3000; ++i) {
    std::array<Point, 4> p;
    for (Point& q : p) q = {coordinate(), coordinate()};
    if (i % 3 == 1) p[3].x = p[0].x, p[1].y = p[2].y;
    expectOrient2d(p[0], p[1], p[2]);
    expectDotSign(p[0], p[1], p[2]);
    expectIncircle(p[0], p[1], p[2], p[3]);
  }
}

TEST(Predicates, WhatIsNotANumberIsAnsweredToo) {
  const double nan = std::nan(""), inf = HUGE_VAL;
  for (const double bad : {nan, inf, -inf, 1e308}) {
    const int o = orient2d({bad, 0}, {1, 0}, {0, 1});
    const int i = incircle({0, 0}, {1, bad}, {0, 1}, {1, 1});
    EXPECT_LE(std::abs(o), 1);
    EXPECT_LE(std::abs(i), 1);
  }
}

/// Recorded cases lie outside the repository: TRISCOPE_PREDICATE_CASES names their folder.
std::vector<std::vector<double>> recordedCases(const char* file, std::size_t columns) {
  const char* folder = std::getenv("TRISCOPE_PREDICATE_CASES");
  const std::filesystem::path root(folder != nullptr ? folder : TRISCOPE_SOURCE_DIR "/../shared/predicates");
  std::ifstream in(root / file);
  std::vector<std::vector<double>> rows;
  std::vector<double> row(columns);
  while (in) {
    for (double& value : row) in >> value;
    if (in) rows.push_back(row);
  }
  return rows;
}

TEST(Predicates, RecordedOrientations) {
  const auto rows = recordedCases("orient2d.txt", 8);
  if (rows.empty()) GTEST_SKIP() << "orient2d.txt is not here; TRISCOPE_PREDICATE_CASES may name its folder";
  EXPECT_GE(rows.size(), 1000u);
  for (const auto& r : rows) {
    EXPECT_EQ(orient2d({r[1], r[2]}, {r[3], r[4]}, {r[5], r[6]}), static_cast<int>(r[7])) << "case " << r[0];
  }
}

TEST(Predicates, RecordedInCircles) {
  const auto rows = recordedCases("incircle.txt", 10);
  if (rows.empty()) GTEST_SKIP() << "incircle.txt is not here; TRISCOPE_PREDICATE_CASES may name its folder";
  EXPECT_GE(rows.size(), 1000u);
  for (const auto& r : rows) {
    EXPECT_EQ(incircle({r[1], r[2]}, {r[3], r[4]}, {r[5], r[6]}, {r[7], r[8]}), static_cast<int>(r[9]))
        << "case " << r[0];
  }
}

TEST(Circumcircle, IsTheSameFarFromTheOrigin) {
  const Point a{1, 2}, b{4, 2.5}, c{2, 5};
  const Circumcircle here = circumcircle(a, b, c);
  EXPECT_NEAR(squaredDistance(here.centre, a), here.squaredRadius, 1e-14);
  EXPECT_NEAR(squaredDistance(here.centre, b), here.squaredRadius, 1e-14);
  EXPECT_NEAR(squaredDistance(here.centre, c), here.squaredRadius, 1e-14);
  const Point far{0x1p40, -0x1p40};
  EXPECT_EQ(circumcircle(a + far, b + far, c + far).squaredRadius, here.squaredRadius);
}

}  // namespace
}  // namespace triscope::predicates_test
