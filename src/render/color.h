// An sRGB colour with straight (not premultiplied) alpha.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/gtc/type_precision.hpp>
#include <glm/vec4.hpp>

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

/// Red, green, blue and alpha, each in [0, 255].
inline glm::dvec4 channelsOf(Color c) { return {c.r, c.g, c.b, c.a}; }

/// Straight blend in sRGB: a at t = 0, b at t = 1.
inline Color mix(Color a, Color b, double t) {
  const glm::u8vec4 c(glm::round(glm::mix(channelsOf(a), channelsOf(b), t)));
  return {c.r, c.g, c.b, c.a};
}

}  // namespace triscope
