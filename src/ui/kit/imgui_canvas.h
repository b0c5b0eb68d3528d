// Draws what render/canvas.h describes into a Dear ImGui draw list: the legend and the labels of the picture.
#pragma once

#include <imgui.h>

#include "render/canvas.h"
#include "ui/model/fonts.h"

namespace triscope {

class ImGuiCanvas : public Canvas {
 public:
  /// Coordinates are pixels of the screen. Both must outlive the canvas.
  ImGuiCanvas(ImDrawList& list, const Fonts& fonts) : list_(list), fonts_(fonts) {}

  void beginClip(Rect rect) override;
  void endClip() override;
  void fillRects(std::span<const FilledRect> rects) override;
  void fillTriangles(std::span<const Pixel> points, std::span<const Index3> triangles, std::span<const Color> fills,
                     bool hatched) override;
  void stroke(const Paths& paths, const LineStyle& style) override;
  void circle(Pixel centre, double radius, const LineStyle& style) override;
  void marks(std::span<const PlacedMark> marks, Shape shape, Color fill, Color outline) override;
  void text(Pixel at, std::string_view text, const TextStyle& style) override;

 private:
  ImDrawList& list_;
  const Fonts& fonts_;
};

}  // namespace triscope
