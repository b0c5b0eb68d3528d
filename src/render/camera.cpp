#include "render/camera.h"

#include <algorithm>
#include <cmath>

namespace triscope {

namespace {

/// A way in the world as one in the picture: y turns round.
Pixel alongPixels(const Camera& camera, Point way) { return camera.scale * Pixel(way.x, -way.y); }
Point alongWorld(const Camera& camera, Pixel way) { return {way.x / camera.scale, -way.y / camera.scale}; }

}  // namespace

glm::dmat3x2 clipFrom(const Camera& camera, Point origin) {
  const glm::dvec2 scale = 2.0 * camera.scale / camera.size();
  const Point shift = origin - camera.centre;
  return {{scale.x, 0.0}, {0.0, scale.y}, scale * glm::dvec2(shift.x, shift.y)};
}

Pixel toPixel(const Camera& camera, Point world) {
  return camera.middle() + alongPixels(camera, world - camera.centre);
}

Point toWorld(const Camera& camera, Pixel pixel) { return camera.centre + alongWorld(camera, pixel - camera.middle()); }

Box visibleBox(const Camera& camera) {
  const Point half{0.5 * camera.width / camera.scale, 0.5 * camera.height / camera.scale};
  return {camera.centre - half, camera.centre + half};
}

bool shows(const Camera& camera, const Box& box) {
  const Box seen = visibleBox(camera);
  return box.lo.x >= seen.lo.x && box.lo.y >= seen.lo.y && box.hi.x <= seen.hi.x && box.hi.y <= seen.hi.y;
}

Camera fitted(const Box& box, double width, double height, double margin) {
  Camera camera;
  camera.width = std::max(width, 1.0);
  camera.height = std::max(height, 1.0);
  if (box.empty()) return camera;
  camera.centre = midpoint(box.lo, box.hi);
  const double room = std::max(1.0, std::min(camera.width, camera.height) - 2.0 * margin);
  const double extent = std::max(box.width(), box.height());
  if (extent <= 0.0) {
    // A single point has no size of its own: show as much around it as it is far from the origin, at least 1.
    camera.scale = room / std::max({1.0, std::fabs(camera.centre.x), std::fabs(camera.centre.y)});
    return camera;
  }
  const double acrossX = std::max(1.0, camera.width - 2.0 * margin);
  const double acrossY = std::max(1.0, camera.height - 2.0 * margin);
  camera.scale =
      std::min(acrossX / std::max(box.width(), 1e-9 * extent), acrossY / std::max(box.height(), 1e-9 * extent));
  return camera;
}

Camera zoomed(const Camera& camera, Pixel pixel, double factor, const Box& bounds) {
  const double extent = bounds.empty() ? 1.0 : std::max({bounds.width(), bounds.height(), 1e-300});
  const double reach = std::max(
      {extent, std::fabs(bounds.lo.x), std::fabs(bounds.lo.y), std::fabs(bounds.hi.x), std::fabs(bounds.hi.y)});
  const double farthest = 0.05 * std::min(camera.width, camera.height) / extent;
  const double nearest = 1e12 / (bounds.empty() ? 1.0 : reach);
  Camera result = camera;
  result.scale = std::clamp(camera.scale * factor, std::min(farthest, nearest), nearest);
  result.centre = toWorld(camera, pixel) - alongWorld(result, pixel - camera.middle());
  return result;
}

Camera panned(const Camera& camera, Pixel delta) {
  Camera result = camera;
  result.centre = camera.centre - alongWorld(camera, delta);
  return result;
}

Camera resized(const Camera& camera, double width, double height) {
  Camera result = camera;
  result.width = std::max(width, 1.0);
  result.height = std::max(height, 1.0);
  return result;
}

}  // namespace triscope
