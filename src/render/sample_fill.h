// Fills whose colours meet edge to edge: sampled 4 × 4 per pixel, so that neighbours leave no seam between them.
#pragma once

#include <span>

#include "render/image.h"
#include "render/pixel.h"
#include "render/scene.h"

namespace triscope {

/// Part of an image, in pixels: [x0, x1) × [y0, y1).
struct PixelBox {
  int x0 = 0;
  int y0 = 0;
  int x1 = 0;
  int y1 = 0;
};

/// Points in pixels. One colour per triangle, or one for all; hatched: only diagonal stripes are filled.
void fillTriangles(Image& image, const PixelBox& clip, std::span<const Pixel> points, std::span<const Index3> triangles,
                   std::span<const Color> fills, bool hatched);

}  // namespace triscope
