// An sRGB colour with straight (not premultiplied) alpha.
#pragma once

#include <cmath>
#include <cstdint>

namespace triscope {

struct Color {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;
  std::uint8_t a = 255;
  friend bool operator==(const Color&, const Color&) = default;
};

/// 0xrrggbb as an opaque colour.
constexpr Color rgb(std::uint32_t hex) {
  return {static_cast<std::uint8_t>(hex >> 16u), static_cast<std::uint8_t>(hex >> 8u), static_cast<std::uint8_t>(hex),
          255};
}

/// The same colour with alpha in [0, 1] times its own.
inline Color faded(Color c, double alpha) {
  c.a = static_cast<std::uint8_t>(std::lround(static_cast<double>(c.a) * alpha));
  return c;
}

/// Straight blend in sRGB: a at t = 0, b at t = 1.
inline Color mix(Color a, Color b, double t) {
  const auto channel = [t](std::uint8_t x, std::uint8_t y) {
    return static_cast<std::uint8_t>(std::lround((1.0 - t) * static_cast<double>(x) + t * static_cast<double>(y)));
  };
  return {channel(a.r, b.r), channel(a.g, b.g), channel(a.b, b.b), channel(a.a, b.a)};
}

}  // namespace triscope
