#include "render/canvas.h"

namespace triscope {

std::span<const Pixel> markOutline(Shape shape) {
  static constexpr std::array<Pixel, 4> diamond{{{0.0, -0.5}, {0.5, 0.0}, {0.0, 0.5}, {-0.5, 0.0}}};
  static constexpr std::array<Pixel, 4> square{{{-0.42, -0.42}, {0.42, -0.42}, {0.42, 0.42}, {-0.42, 0.42}}};
  static constexpr std::array<Pixel, 3> triangle{{{0.0, -0.55}, {0.5, 0.35}, {-0.5, 0.35}}};
  static constexpr std::array<Pixel, 4> cross{{{-0.45, -0.45}, {0.45, 0.45}, {-0.45, 0.45}, {0.45, -0.45}}};
  switch (shape) {
    case Shape::diamond:
      return diamond;
    case Shape::square:
      return square;
    case Shape::triangle:
      return triangle;
    case Shape::cross:
      return cross;
    case Shape::circle:
    case Shape::ring:
      break;
  }
  return {};
}

}  // namespace triscope
