#include "render/stroke.h"

#include <algorithm>
#include <cmath>

namespace triscope {

double dashUnit(float width) { return std::max(1.0, 0.6 * static_cast<double>(width)); }

Paths dashed(std::span<const Pixel> polyline, const DashPattern& pattern, double unit) {
  Paths result;
  if (polyline.size() < 2) return result;
  int index = 0;
  double left = static_cast<double>(pattern.lengths[0]) * unit;
  bool on = true;
  result.starts.push_back(0);
  result.points.push_back(polyline[0]);
  for (std::size_t i = 0; i + 1 < polyline.size(); ++i) {
    Pixel from = polyline[i];
    const Pixel to = polyline[i + 1];
    double rest = distance(from, to);
    while (rest > left) {
      from = from + (left / rest) * (to - from);
      rest -= left;
      if (on) result.points.push_back(from);
      on = !on;
      if (on) {
        result.starts.push_back(static_cast<std::uint32_t>(result.points.size()));
        result.points.push_back(from);
      }
      index = (index + 1) % pattern.count;
      left = static_cast<double>(pattern.lengths[static_cast<std::size_t>(index)]) * unit;
    }
    left -= rest;
    if (on) result.points.push_back(to);
  }
  return result;
}

std::array<Pixel, 4> segmentOutline(Pixel a, Pixel b, double width) {
  const double size = distance(a, b);
  const Pixel along = size > 0.0 ? (1.0 / size) * (b - a) : Pixel{1.0, 0.0};
  const Pixel side = (0.5 * width) * perpendicular(along);
  return {a + side, b + side, b - side, a - side};
}

std::vector<Pixel> circlePolyline(Pixel centre, double radius) {
  const int n = std::clamp(static_cast<int>(14.0 * std::sqrt(std::max(radius, 1.0))), 16, 720);
  std::vector<Pixel> points;
  points.reserve(static_cast<std::size_t>(n) + 1);
  for (int i = 0; i < n; ++i) {
    const double angle = 2.0 * 3.14159265358979 * i / n;
    points.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
  }
  points.push_back(points.front());
  return points;
}

}  // namespace triscope
