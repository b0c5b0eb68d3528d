// The sweep against all pairs of edges, on random polygons of few coordinates (so that every degeneracy happens).
#include "core/domain/sweep_line.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <sstream>

#include "core/domain/check.h"
#include "core/geometry/predicates.h"

namespace triscope::sweep_line_test {
namespace {

bool between(double a, double x, double b) { return std::min(a, b) <= x && x <= std::max(a, b); }

bool onSegment(Point a, Point b, Point p) {
  return orient2d(a, b, p) == 0 && between(a.x, p.x, b.x) && between(a.y, p.y, b.y);
}

/// Do two segments share any point?
bool meet(Point a, Point b, Point c, Point d) {
  if (orient2d(a, b, c) * orient2d(a, b, d) < 0 && orient2d(c, d, a) * orient2d(c, d, b) < 0) return true;
  return onSegment(a, b, c) || onSegment(a, b, d) || onSegment(c, d, a) || onSegment(c, d, b);
}

/// A loop is simple when edges that follow one another share only their common point, and others nothing.
bool simpleByAllPairs(const std::vector<Point>& p) {
  const std::size_t n = p.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      const Point a = p[i], b = p[(i + 1) % n], c = p[j], d = p[(j + 1) % n];
      const bool next = j == i + 1, previous = (j + 1) % n == i;
      if (next && previous) return false;
      if (next       ? onSegment(a, b, d) || onSegment(c, d, a)
          : previous ? onSegment(a, b, c) || onSegment(c, d, b)
                     : meet(a, b, c, d)) {
        return false;
      }
    }
  }
  return true;
}

bool insideByRay(const std::vector<Point>& p, Point q) {
  bool inside = false;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Point a = p[i], b = p[(i + 1) % p.size()];
    if ((a.y > q.y) == (b.y > q.y)) continue;
    if (orient2d(a, b, q) * (b.y > a.y ? 1 : -1) > 0) inside = !inside;
  }
  return inside;
}

void addLoop(Domain& domain, LoopRole role, const std::vector<Point>& points) {
  const auto first = static_cast<std::uint32_t>(domain.curves.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    domain.curves.push_back({.a = points[i], .b = points[(i + 1) % points.size()]});
  }
  domain.loops.push_back(
      {"loop " + std::to_string(domain.loops.size()), role, first, static_cast<std::uint32_t>(points.size())});
}

std::string text(const std::vector<Point>& points) {
  std::ostringstream out;
  for (const Point p : points) out << "[" << p.x << "," << p.y << "],";
  return out.str();
}

/// Random points on a small grid, neighbours different.
std::vector<Point> randomLoop(std::mt19937& random, int size, int grid) {
  std::vector<Point> points;
  while (static_cast<int>(points.size()) < size) {
    const Point p{static_cast<double>(static_cast<int>(random() % static_cast<unsigned>(grid))),
                  static_cast<double>(static_cast<int>(random() % static_cast<unsigned>(grid)))};
    if (points.empty() || (!(p == points.back()) && !(static_cast<int>(points.size()) == size - 1 && p == points[0]))) {
      points.push_back(p);
    }
  }
  return points;
}

TEST(SweepLine, AgreesWithAllPairsOnSingleLoops) {
  std::mt19937 random(11);
  int simple = 0;
  for (int i = 0; i < 60000; ++i) {
    const auto points = randomLoop(random, 3 + i % 6, 3 + i % 5);
    Domain domain;
    addLoop(domain, LoopRole::outer, points);
    const bool expected = simpleByAllPairs(points);
    simple += expected ? 1 : 0;
    ASSERT_EQ(checkDomain(domain).ok(), expected) << text(points);
  }
  EXPECT_GT(simple, 5000);
}

TEST(SweepLine, AgreesWithAllPairsOnTwoLoops) {
  std::mt19937 random(12);
  int accepted = 0;
  int nested = 0;
  for (int i = 0; i < 60000; ++i) {
    auto outer = randomLoop(random, 3 + i % 3, 6);
    auto hole = randomLoop(random, 3, 4);
    const Point offset{static_cast<double>(random() % 14), static_cast<double>(random() % 14)};
    for (Point& p : outer) p = 3.0 * p;
    for (Point& p : hole) p = p + offset;
    if (!simpleByAllPairs(outer) || !simpleByAllPairs(hole)) continue;
    bool apart = true;
    for (std::size_t j = 0; j < outer.size(); ++j) {
      for (std::size_t k = 0; k < hole.size(); ++k) {
        if (meet(outer[j], outer[(j + 1) % outer.size()], hole[k], hole[(k + 1) % hole.size()])) apart = false;
      }
    }
    const bool inside = apart && insideByRay(outer, hole[0]);
    nested += apart && !inside ? 1 : 0;
    accepted += inside ? 1 : 0;
    Domain domain;
    addLoop(domain, LoopRole::outer, outer);
    addLoop(domain, LoopRole::hole, hole);
    ASSERT_EQ(checkDomain(domain).ok(), inside) << text(outer) << "\n" << text(hole);
  }
  EXPECT_GT(accepted, 200);
  EXPECT_GT(nested, 200);
}

TEST(SweepLine, AgreesWithAllPairsOnSegments) {
  std::mt19937 random(13);
  int accepted = 0;
  for (int i = 0; i < 60000; ++i) {
    const auto p = randomLoop(random, 6, 6);
    // Three single segments in a large square; they may share ends and nothing else.
    bool expected = true;
    for (std::size_t s = 0; s < 6; s += 2) {
      for (std::size_t t = s + 2; t < 6; t += 2) {
        const Point a = p[s], b = p[s + 1], c = p[t], d = p[t + 1];
        const bool joined = a == c || a == d || b == c || b == d;
        if (!joined) {
          if (meet(a, b, c, d)) expected = false;
          continue;
        }
        const Point shared = a == c || a == d ? a : b;
        const Point e = shared == a ? b : a, f = shared == c ? d : c;
        if (onSegment(a, b, f) || onSegment(c, d, e)) expected = false;
      }
    }
    Domain domain;
    addLoop(domain, LoopRole::outer, {{-1, -1}, {7, -1}, {7, 7}, {-1, 7}});
    for (std::size_t s = 0; s < 6; s += 2) {
      domain.curves.push_back({.a = p[s], .b = p[s + 1]});
      domain.loops.push_back(
          {"segment " + std::to_string(s), LoopRole::chain, static_cast<std::uint32_t>(domain.curves.size()) - 1, 1});
    }
    accepted += expected ? 1 : 0;
    ASSERT_EQ(checkDomain(domain).ok(), expected) << text(p);
  }
  EXPECT_GT(accepted, 5000);
}

TEST(SweepLine, HundredThousandEdgesAreChecked) {
  // A comb of long slanted teeth: every bounding box overlaps thousands of others.
  std::vector<Point> points;
  const int teeth = 25000;
  for (int i = 0; i < teeth; ++i) {
    points.push_back({2.0 * i, 0.0});
    points.push_back({2.0 * i + 1.0 + teeth, static_cast<double>(teeth)});
    points.push_back({2.0 * i + 1.5 + teeth, static_cast<double>(teeth)});
    points.push_back({2.0 * i + 0.5, 0.0});
  }
  points.push_back({2.0 * teeth, -5.0});
  points.push_back({-5.0, -5.0});
  Domain domain;
  addLoop(domain, LoopRole::outer, points);
  const auto checked = checkDomain(domain);
  EXPECT_TRUE(checked.ok()) << describe(checked.error());

  domain.curves[50000].b.y = domain.curves[50001].a.y = -6.0;
  EXPECT_FALSE(checkDomain(domain).ok());
}

}  // namespace
}  // namespace triscope::sweep_line_test
