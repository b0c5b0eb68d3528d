// What a picture is drawn on. Everything here is in pixels, origin top left, y down.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "render/font.h"
#include "render/pixel.h"
#include "render/scene.h"

namespace triscope {

struct Rect {
  double x = 0.0;
  double y = 0.0;
  double width = 0.0;
  double height = 0.0;
};

struct FilledRect {
  Rect rect;
  Color fill;
};

/// Polylines end to end in one array; polyline i runs from starts[i] to starts[i + 1] (the last one to the end).
struct Paths {
  std::vector<Pixel> points;
  std::vector<std::uint32_t> starts;
  [[nodiscard]] std::span<const Pixel> path(std::size_t i) const {
    const std::size_t end = i + 1 < starts.size() ? starts[i + 1] : points.size();
    return std::span(points).subspan(starts[i], end - starts[i]);
  }
};

struct PlacedMark {
  Pixel at;
  float size = 0.0f;
};

struct TextStyle {
  double size = 13.0;  // em
  Weight weight = Weight::regular;
  Color color;
  Color halo{0, 0, 0, 0};  // alpha 0: none
  Anchor anchor = Anchor::left;
};

class Canvas {
 public:
  Canvas() = default;
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;
  virtual ~Canvas() = default;

  /// Nothing is drawn outside the rectangle until endClip().
  virtual void beginClip(Rect rect) = 0;
  virtual void endClip() = 0;
  virtual void fillRects(std::span<const FilledRect> rects) = 0;
  /// One colour per triangle, or one for all.
  virtual void fillTriangles(std::span<const Pixel> points, std::span<const Index3> triangles,
                             std::span<const Color> fills, bool hatched) = 0;
  virtual void stroke(const Paths& paths, const LineStyle& style) = 0;
  virtual void circle(Pixel centre, double radius, const LineStyle& style) = 0;
  virtual void marks(std::span<const PlacedMark> marks, Shape shape, Color fill, Color outline) = 0;
  /// `at` is on the baseline.
  virtual void text(Pixel at, std::string_view text, const TextStyle& style) = 0;
};

/// Corner points of a mark of size 1 about (0, 0), y down; empty for circle and ring. A cross has two strokes.
std::span<const Pixel> markOutline(Shape shape);

}  // namespace triscope
