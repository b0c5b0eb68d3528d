#include "render/image.h"

#include <cmath>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include <stb_image_write.h>  // NOLINT(clang-analyzer-*): findings within are not ours

namespace triscope {

static_assert(sizeof(Color) == 4, "pixels are written as they lie in memory");

Color blend(Color below, Color over, float coverage) {
  const float a = coverage * static_cast<float>(over.a) / 255.0f;
  if (a <= 0.0f) return below;
  const float b = static_cast<float>(below.a) / 255.0f;
  const float total = a + b * (1.0f - a);
  const auto channel = [&](std::uint8_t top, std::uint8_t bottom) {
    const float c = (static_cast<float>(top) * a + static_cast<float>(bottom) * b * (1.0f - a)) / total;
    return static_cast<std::uint8_t>(std::lround(c));
  };
  return {channel(over.r, below.r), channel(over.g, below.g), channel(over.b, below.b),
          static_cast<std::uint8_t>(std::lround(total * 255.0f))};
}

Result<std::string> encodePng(const Image& image) {
  constexpr int kMost = 1 << 15;
  if (image.width < 1 || image.height < 1 || image.width > kMost || image.height > kMost) {
    Error error;
    error.kind = ErrorKind::usage;
    error.message = "a picture of " + std::to_string(image.width) + " by " + std::to_string(image.height) +
                    " pixels cannot be made";
    error.hint = "give a width and a height between 1 and " + std::to_string(kMost);
    return error;
  }
  std::string bytes;
  const auto append = [](void* context, void* data, int size) {
    static_cast<std::string*>(context)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
  };
  if (stbi_write_png_to_func(append, &bytes, image.width, image.height, 4, image.pixels.data(), image.width * 4) == 0) {
    Error error;
    error.kind = ErrorKind::internal;
    error.message = "the picture could not be compressed";
    error.hint = "try a smaller picture";
    return error;
  }
  return bytes;
}

}  // namespace triscope
