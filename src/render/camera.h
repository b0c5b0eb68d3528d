// The window onto the plane: world coordinates (y up) to pixels (origin top left, y down) and back.
#pragma once

#include <glm/mat3x2.hpp>

#include "core/base/point.h"
#include "render/pixel.h"

namespace triscope {

struct Camera {
  Point centre;        // world point in the middle of the picture
  double scale = 1.0;  // pixels per world unit, > 0
  double width = 1.0;  // of the picture, pixels
  double height = 1.0;
  friend bool operator==(const Camera&, const Camera&) = default;
  /// Of the picture, in pixels.
  [[nodiscard]] Pixel size() const { return {width, height}; }
  [[nodiscard]] Pixel middle() const { return 0.5 * size(); }
};

/// Takes (x, y, 1), a place in the world less `origin`, to OpenGL's clip coordinates: -1 to 1 across the picture, y up.
glm::dmat3x2 clipFrom(const Camera& camera, Point origin);
Pixel toPixel(const Camera& camera, Point world);
Point toWorld(const Camera& camera, Pixel pixel);
/// The part of the world that the picture shows.
Box visibleBox(const Camera& camera);
/// Whether the picture shows the whole of a box.
bool shows(const Camera& camera, const Box& box);
/// Shows the whole box with `margin` pixels on every side; an empty or flat box is given some extent.
Camera fitted(const Box& box, double width, double height, double margin);
/// Magnified by `factor` (> 1 nearer) while the world point under `pixel` stays there; the scale stays within the
/// limits at which a double still resolves a pixel at `bounds`.
Camera zoomed(const Camera& camera, Pixel pixel, double factor, const Box& bounds);
/// Moved so that what was under pixel (0, 0) is now under `delta`.
Camera panned(const Camera& camera, Pixel delta);
/// The same view in a picture of another size: centre and scale stay.
Camera resized(const Camera& camera, double width, double height);

}  // namespace triscope
