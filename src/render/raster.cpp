#include "render/raster.h"

#include <algorithm>
#include <cmath>

#include "render/coverage.h"
#include "render/sample_fill.h"
#include "render/stroke.h"

namespace triscope {
namespace {

class RasterCanvas final : public Canvas {
 public:
  explicit RasterCanvas(Image& image)
      : image_(image), coverage_(image.width, image.height), clip_{0, 0, image.width, image.height} {}

  void beginClip(Rect rect) override {
    clip_ = {std::max(0, static_cast<int>(std::floor(rect.x))), std::max(0, static_cast<int>(std::floor(rect.y))),
             std::min(image_.width, static_cast<int>(std::ceil(rect.x + rect.width))),
             std::min(image_.height, static_cast<int>(std::ceil(rect.y + rect.height)))};
  }

  void endClip() override { clip_ = {0, 0, image_.width, image_.height}; }

  void fillRects(std::span<const FilledRect> rects) override {
    std::vector<Pixel> points;
    std::vector<Index3> halves;
    std::vector<Color> fills;
    points.reserve(rects.size() * 4);
    for (const FilledRect& r : rects) {
      const auto first = static_cast<std::uint32_t>(points.size());
      const double right = r.rect.x + r.rect.width;
      const double bottom = r.rect.y + r.rect.height;
      points.insert(points.end(), {{r.rect.x, r.rect.y}, {right, r.rect.y}, {right, bottom}, {r.rect.x, bottom}});
      halves.insert(halves.end(), {{first, first + 1, first + 2}, {first, first + 2, first + 3}});
      fills.insert(fills.end(), 2, r.fill);
    }
    triscope::fillTriangles(image_, clip_, points, halves, fills, false);
  }

  void fillTriangles(std::span<const Pixel> points, std::span<const Index3> triangles, std::span<const Color> fills,
                     bool hatched) override {
    triscope::fillTriangles(image_, clip_, points, triangles, fills, hatched);
  }

  void stroke(const Paths& paths, const LineStyle& style) override {
    const DashPattern pattern = patternOf(style.dash);
    for (std::size_t i = 0; i < paths.starts.size(); ++i) {
      if (pattern.count == 0) {
        addPolyline(paths.path(i), style.width);
        continue;
      }
      const Paths dashes = dashed(paths.path(i), pattern, dashUnit(style.width));
      for (std::size_t k = 0; k < dashes.starts.size(); ++k) addPolyline(dashes.path(k), style.width);
    }
    paint(style.color);
  }

  void circle(Pixel centre, double radius, const LineStyle& style) override {
    stroke({circlePolyline(centre, radius), {0}}, style);
  }

  void marks(std::span<const PlacedMark> marks, Shape shape, Color fill, Color outline) override {
    if (outline.a > 0) {
      for (const PlacedMark& mark : marks) addMark(mark, shape, 2.0);
      paint(outline);
    }
    for (const PlacedMark& mark : marks) addMark(mark, shape, 0.0);
    paint(fill);
  }

  void text(Pixel at, std::string_view text, const TextStyle& style) override {
    if (style.anchor != Anchor::left) {
      const double width = textWidth(text, style.size, style.weight);
      at.x -= style.anchor == Anchor::right ? width : 0.5 * width;
    }
    const auto contours = textContours(text, at, style.size, style.weight);
    if (style.halo.a > 0) {
      for (const auto& contour : contours) {
        addPolyline(contour, 4.0);
        addClosing(contour, 4.0);
      }
      paint(style.halo);
    }
    for (const auto& contour : contours) coverage_.addContour(contour);
    paint(style.color);
  }

 private:
  void paint(Color color) { coverage_.paint(image_, color, clip_.x0, clip_.y0, clip_.x1, clip_.y1); }

  void addPolyline(std::span<const Pixel> polyline, double width) {
    for (std::size_t i = 0; i + 1 < polyline.size(); ++i) {
      coverage_.addPolygon(segmentOutline(polyline[i], polyline[i + 1], width));
      if (width >= 1.4 && i > 0) addJoint(polyline[i], width);
    }
    const bool closed = polyline.size() > 2 && polyline.front() == polyline.back();
    if (closed && width >= 1.4) addJoint(polyline.front(), width);
  }

  void addClosing(std::span<const Pixel> contour, double width) {
    coverage_.addPolygon(segmentOutline(contour.back(), contour.front(), width));
  }

  // Round joints: the outer side of a bend would be left open otherwise.
  void addJoint(Pixel at, double width) {
    const std::vector<Pixel> disc = circlePolyline(at, 0.5 * width);
    coverage_.addPolygon(std::span(disc).first(disc.size() - 1));
  }

  void addMark(const PlacedMark& mark, Shape shape, double grow) {
    const double size = static_cast<double>(mark.size) + grow;
    const double pen = std::max(1.2, 0.18 * static_cast<double>(mark.size)) + grow;
    if (shape == Shape::circle) {
      const std::vector<Pixel> disc = circlePolyline(mark.at, 0.5 * size);
      coverage_.addPolygon(std::span(disc).first(disc.size() - 1));
    } else if (shape == Shape::ring) {
      addPolyline(circlePolyline(mark.at, 0.5 * (static_cast<double>(mark.size) - pen)), pen);
    } else {
      std::vector<Pixel> corners;
      for (const Pixel& p : markOutline(shape)) corners.push_back(mark.at + size * p);
      if (shape != Shape::cross) {
        coverage_.addPolygon(corners);
        return;
      }
      coverage_.addPolygon(segmentOutline(corners[0], corners[1], pen));
      coverage_.addPolygon(segmentOutline(corners[2], corners[3], pen));
    }
  }

  Image& image_;
  Coverage coverage_;
  PixelBox clip_;
};

}  // namespace

std::unique_ptr<Canvas> rasterCanvas(Image& image) { return std::make_unique<RasterCanvas>(image); }

Image rasterize(const Scene& scene, const Camera& camera, const PictureLayout& layout, const PictureOptions& options) {
  Image image(static_cast<int>(std::ceil(layout.width)), static_cast<int>(std::ceil(layout.height)),
              {255, 255, 255, 0});
  const auto canvas = rasterCanvas(image);
  drawPicture(scene, camera, layout, options, *canvas);
  return image;
}

}  // namespace triscope
