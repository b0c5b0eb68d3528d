// A point or vector of the plane, and the few operations on it that decisions are made of.
// Only + - * / and sqrt are used: IEEE 754 fixes their results, so every compiler gives the same bits.
#pragma once

#include <cmath>

namespace triscope {

template <class T>
constexpr T squared(T x) {
  return x * x;
}

struct Point {
  double x = 0.0;
  double y = 0.0;
  friend bool operator==(const Point&, const Point&) = default;
};

inline Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
inline Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
inline Point operator*(double s, Point a) { return {s * a.x, s * a.y}; }
inline double dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }
/// z component of the cross product: twice the signed area spanned by a and b.
inline double cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }
inline double squaredLength(Point a) { return dot(a, a); }
inline double length(Point a) { return std::sqrt(dot(a, a)); }
inline double distance(Point a, Point b) { return length(b - a); }
inline double squaredDistance(Point a, Point b) { return squaredLength(b - a); }
inline Point midpoint(Point a, Point b) { return {0.5 * (a.x + b.x), 0.5 * (a.y + b.y)}; }
/// Left of the other, or below where neither is.
inline bool leftOf(Point a, Point b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }
/// a turned by +90 degrees.
inline Point perpendicular(Point a) { return {-a.y, a.x}; }

/// Axis-aligned box; empty when lo.x > hi.x.
struct Box {
  Point lo{1e300, 1e300};
  Point hi{-1e300, -1e300};
  void include(Point p) {
    lo = {p.x < lo.x ? p.x : lo.x, p.y < lo.y ? p.y : lo.y};
    hi = {p.x > hi.x ? p.x : hi.x, p.y > hi.y ? p.y : hi.y};
  }
  [[nodiscard]] bool empty() const { return lo.x > hi.x; }
  [[nodiscard]] double width() const { return hi.x - lo.x; }
  [[nodiscard]] double height() const { return hi.y - lo.y; }
};

}  // namespace triscope
