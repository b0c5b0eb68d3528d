// Draws pictures in memory, without a display: fills by 4 × 4 samples, everything thin by exact coverage.
#pragma once

#include <memory>

#include "render/image.h"
#include "render/picture.h"

namespace triscope {

/// A canvas that draws into `image`, which must outlive it.
std::unique_ptr<Canvas> rasterCanvas(Image& image);

/// The picture as pixels; its size is that of the layout, rounded up.
Image rasterize(const Scene& scene, const Camera& camera, const PictureLayout& layout, const PictureOptions& options);

}  // namespace triscope
