// A picture in memory, and the one file format that it is written in.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "render/color.h"

namespace triscope {

/// Rows from the top, pixels from the left, straight alpha.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<Color> pixels;

  Image() = default;
  Image(int w, int h, Color fill)
      : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), fill) {}
  Color& at(int x, int y) {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
  }
  [[nodiscard]] Color at(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
  }
};

/// `over` with coverage in [0, 1] on top of `below`.
Color blend(Color below, Color over, float coverage);

/// The bytes of a PNG file. Fails only when the image is empty or too large for the format.
Result<std::string> encodePng(const Image& image);

}  // namespace triscope
