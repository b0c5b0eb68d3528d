// The picture as a vector file: text stays text, each style is one path, coordinates have as many digits as show.
#pragma once

#include <string>

#include "render/picture.h"

namespace triscope {

/// A complete SVG 1.1 document of the size of the layout.
std::string svg(const Scene& scene, const Camera& camera, const PictureLayout& layout, const PictureOptions& options);

}  // namespace triscope
