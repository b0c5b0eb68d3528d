#include "render/picture.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "core/base/number.h"
#include "render/legend_panel.h"

namespace triscope {
namespace {

constexpr double kPadding = 14.0;
constexpr double kTitleSize = 16.0;
constexpr double kCaptionSize = 12.5;
constexpr double kCaptionLine = 18.0;
constexpr double kScaleBarHeight = 22.0;
constexpr int kFadeSteps = 6;  // strokes of one style are drawn in this many strengths

std::vector<std::string> brokenIntoLines(const std::string& text, double width, double size) {
  std::vector<std::string> lines;
  std::string line;
  std::size_t from = 0;
  while (from < text.size()) {
    std::size_t to = text.find_first_of(" \n", from);
    if (to == std::string::npos) to = text.size();
    const std::string word = text.substr(from, to - from);
    std::string longer = line;
    if (!line.empty()) longer += ' ';
    longer += word;
    if (!line.empty() && textWidth(longer, size) > width) {
      lines.push_back(line);
      line = word;
    } else {
      line = std::move(longer);
    }
    if (to < text.size() && text[to] == '\n') {
      lines.push_back(line);
      line.clear();
    }
    from = to + 1;
  }
  if (!line.empty()) lines.push_back(line);
  return lines;
}

struct Margins {
  double top = 0.0;
  double right = 0.0;
  double bottom = 0.0;
  double legendWidth = 0.0;
  double legendHeight = 0.0;
};

Margins marginsOf(const Scene& scene, const PictureOptions& options) {
  const double s = options.scale;
  Margins m;
  m.top = options.title.empty() ? kPadding * s : (kPadding + kTitleSize + 12.0) * s;
  if (options.legend && !scene.legend.empty()) {
    const LegendSize size = legendSize(scene.legend, s);
    m.legendWidth = size.width;
    m.legendHeight = size.height;
    m.right = (2.0 * kPadding) * s + size.width;
  } else {
    m.right = kPadding * s;
  }
  m.bottom = kPadding * s + (options.scaleBar ? kScaleBarHeight * s : 0.0);
  return m;
}

PictureLayout assemble(const Margins& m, double plotWidth, double plotHeight, const PictureOptions& options,
                       std::vector<std::string> lines) {
  const double s = options.scale;
  PictureLayout layout;
  layout.plot = {kPadding * s, m.top, plotWidth, plotHeight};
  layout.width = layout.plot.x + plotWidth + m.right;
  layout.height = m.top + plotHeight + m.bottom + kCaptionLine * s * static_cast<double>(lines.size());
  layout.legend = {layout.plot.x + plotWidth + kPadding * s, m.top, m.legendWidth, m.legendHeight};
  layout.captionLines = std::move(lines);
  return layout;
}

// Cohen and Sutherland's question: does the segment certainly miss the rectangle?
bool misses(Pixel a, Pixel b, const Rect& r) {
  return std::max(a.x, b.x) < r.x || std::min(a.x, b.x) > r.x + r.width || std::max(a.y, b.y) < r.y ||
         std::min(a.y, b.y) > r.y + r.height;
}

// Where the camera's picture is put on the canvas, and what of it can be seen.
class Plotter {
 public:
  Plotter(const Camera& camera, const Rect& plot, double scale, Canvas& canvas)
      : camera_(camera), plot_(plot), scale_(scale), canvas_(canvas) {}

  void draw(const Layer& layer) {
    for (const SquareBatch& batch : layer.squares) draw(batch);
    for (const TriangleBatch& batch : layer.triangles) draw(batch);
    for (const LineBatch& batch : layer.lines) strokeSegments(pixels(batch.points), batch.segments, batch.style);
    for (const Circle& circle : layer.circles) draw(circle);
    for (const MarkBatch& batch : layer.marks) draw(batch);
  }

  [[nodiscard]] Pixel pixel(Point world) const { return Pixel(plot_.x, plot_.y) + toPixel(camera_, world); }

 private:
  [[nodiscard]] std::vector<Pixel> pixels(const std::vector<Point>& world) const {
    std::vector<Pixel> result(world.size());
    for (std::size_t i = 0; i < world.size(); ++i) result[i] = pixel(world[i]);
    return result;
  }

  [[nodiscard]] LineStyle scaled(LineStyle style) const {
    style.width *= static_cast<float>(scale_);
    return style;
  }

  void draw(const SquareBatch& batch) {
    std::vector<FilledRect> rects;
    std::vector<Pixel> corners;
    std::vector<Index2> sides;
    for (const SquareBatch::Square& square : batch.squares) {
      const double side = square.side * camera_.scale;
      const Pixel low = pixel(square.corner);
      const Rect rect{low.x, low.y - side, side, side};
      if (misses({rect.x, rect.y}, {rect.x + side, rect.y + side}, plot_)) continue;
      if (square.fill.a > 0) rects.push_back({rect, square.fill});
      const auto first = static_cast<std::uint32_t>(corners.size());
      corners.insert(corners.end(), {{rect.x, rect.y}, low, {low.x + side, low.y}, {low.x + side, rect.y}});
      sides.insert(sides.end(), {{first, first + 1}, {first + 1, first + 2}});
      sides.insert(sides.end(), {{first + 2, first + 3}, {first + 3, first}});
    }
    canvas_.fillRects(rects);
    if (batch.outline.width > 0.0f) strokeSegments(corners, sides, batch.outline);
  }

  void draw(const TriangleBatch& batch) {
    const std::vector<Pixel> points = pixels(batch.points);
    if (!batch.fills.empty()) {
      std::vector<Index3> seen;
      std::vector<Color> fills;
      const bool each = batch.fills.size() == batch.triangles.size() && batch.fills.size() > 1;
      for (std::size_t i = 0; i < batch.triangles.size(); ++i) {
        const Color fill = each ? batch.fills[i] : batch.fills[0];
        if (fill.a == 0) continue;
        const Index3& t = batch.triangles[i];
        const Pixel a = points[t[0]];
        const Pixel b = points[t[1]];
        const Pixel c = points[t[2]];
        const Pixel low = glm::min(a, glm::min(b, c));
        const Pixel high = glm::max(a, glm::max(b, c));
        if (misses(low, high, plot_)) continue;
        seen.push_back(t);
        if (each) fills.push_back(fill);
      }
      if (!each) fills.push_back(batch.fills[0]);
      if (!seen.empty()) canvas_.fillTriangles(points, seen, fills, batch.hatched);
    }
    if (batch.wire.width > 0.0f) strokeSegments(points, batch.edges, batch.wire);
  }

  void strokeSegments(const std::vector<Pixel>& points, const std::vector<Index2>& segments, LineStyle style) {
    if (segments.empty()) return;
    std::array<Paths, kFadeSteps> groups;
    std::array<std::uint32_t, kFadeSteps> last;
    last.fill(~0u);
    for (const Index2& segment : segments) {
      const Pixel a = points[segment[0]];
      const Pixel b = points[segment[1]];
      if (misses(a, b, plot_)) continue;
      std::size_t step = kFadeSteps - 1;
      if (style.fades) {
        const double strength = wireFade(distance(a, b) / scale_);
        step = std::min<std::size_t>(kFadeSteps - 1, static_cast<std::size_t>(strength * kFadeSteps));
      }
      Paths& group = groups[step];
      if (last[step] != segment[0]) {
        group.starts.push_back(static_cast<std::uint32_t>(group.points.size()));
        group.points.push_back(a);
      }
      group.points.push_back(b);
      last[step] = segment[1];
    }
    for (std::size_t step = 0; step < kFadeSteps; ++step) {
      if (groups[step].points.empty()) continue;
      LineStyle own = scaled(style);
      const double strength = static_cast<double>(step + 1) / kFadeSteps;
      own.color = faded(style.color, strength);
      own.width *= static_cast<float>(0.5 + 0.5 * strength);
      canvas_.stroke(groups[step], own);
    }
  }

  void draw(const Circle& circle) {
    const double radius = std::max(circle.radius * camera_.scale, static_cast<double>(circle.minimumRadius) * scale_);
    canvas_.circle(pixel(circle.centre), radius, scaled(circle.style));
  }

  void draw(const MarkBatch& batch) {
    constexpr float kLeastOutlined = 5.0f;  // pixels: an outline would hide what is smaller
    std::vector<PlacedMark> large;
    std::vector<PlacedMark> small;
    for (std::size_t i = 0; i < batch.at.size(); ++i) {
      const Pixel p = pixel(batch.at[i]);
      const double reach = static_cast<double>(batch.size) * scale_;
      if (misses(p - reach, p + reach, plot_)) continue;
      const double room = batch.spacing.empty() ? 1e9 : static_cast<double>(batch.spacing[i]) * camera_.scale / scale_;
      const float size = markSize(batch.size, room);
      (size < kLeastOutlined ? small : large).push_back({p, size * static_cast<float>(scale_)});
    }
    if (!small.empty()) canvas_.marks(small, batch.shape, batch.fill, {0, 0, 0, 0});
    if (!large.empty()) canvas_.marks(large, batch.shape, batch.fill, batch.outline);
  }

  const Camera& camera_;
  Rect plot_;
  double scale_;
  Canvas& canvas_;
};

// 1, 2 or 5 times a power of ten, at most a quarter of the plot.
double niceLength(double most) {
  double length = std::pow(10.0, std::floor(std::log10(most)));
  for (const double factor : {5.0, 2.0}) {
    if (length * factor <= most) return length * factor;
  }
  return length;
}

void drawScaleBar(const Scene& scene, const Camera& camera, const PictureLayout& layout, double s, Canvas& canvas) {
  if (!(camera.scale > 0.0) || layout.plot.width < 40.0) return;
  const double length = niceLength(0.25 * layout.plot.width / camera.scale);
  const double width = length * camera.scale;
  const Pixel left{layout.plot.x, layout.plot.y + layout.plot.height + 13.0 * s};
  const Pixel right{left.x + width, left.y};
  const double tick = 4.0 * s;
  const Paths bar{{{left.x, left.y - tick},
                   {left.x, left.y + tick},
                   left,
                   right,
                   {right.x, right.y - tick},
                   {right.x, right.y + tick}},
                  {0, 2, 4}};
  canvas.stroke(bar, {scene.theme.text, static_cast<float>(1.2 * s), Dash::solid, false});
  canvas.text({right.x + 8.0 * s, right.y + 4.2 * s}, compact(length),
              {12.0 * s, Weight::regular, scene.theme.text, {0, 0, 0, 0}, Anchor::left});
}

bool overlap(const Rect& a, const Rect& b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

}  // namespace

PictureLayout layoutWithin(double width, double height, double aspect, const Scene& scene,
                           const PictureOptions& options) {
  const double s = options.scale;
  const Margins m = marginsOf(scene, options);
  const double allWidth = std::max(16.0, width - kPadding * s - m.right);
  PictureLayout layout;
  // The caption is as wide as the plot and the legend, the plot as high as the caption leaves it: two goes settle it.
  double left = kPadding * s;
  for (int go = 0; go < 2; ++go) {
    std::vector<std::string> lines = brokenIntoLines(options.caption, width - 2.0 * left, kCaptionSize * s);
    const double below = kCaptionLine * s * static_cast<double>(lines.size());
    double plotWidth = allWidth;
    double plotHeight = std::max(16.0, height - m.top - m.bottom - below);
    if (aspect > 0.0) {
      plotWidth = std::max(std::min(plotWidth, plotHeight * aspect), std::min(plotWidth, 240.0 * s));
      plotHeight = std::max(std::min(plotHeight, plotWidth / aspect), std::min(plotHeight, 120.0 * s));
    }
    layout = assemble(m, plotWidth, plotHeight, options, std::move(lines));
    const double spare = 0.5 * (allWidth - plotWidth);
    layout.plot.x += spare;
    layout.legend.x += spare;
    left = layout.plot.x;
  }
  layout.width = width;
  layout.height = height;
  return layout;
}

PictureLayout layoutAround(const Camera& camera, const Scene& scene, const PictureOptions& options) {
  const double s = options.scale;
  const Margins m = marginsOf(scene, options);
  const double width = camera.width + m.right - kPadding * s;
  return assemble(m, camera.width, camera.height, options, brokenIntoLines(options.caption, width, kCaptionSize * s));
}

std::vector<PlacedLabel> placeLabels(const Scene& scene, const Camera& camera, double scale,
                                     std::span<const Rect> avoid) {
  std::vector<PlacedLabel> placed;
  std::vector<Rect> taken;
  for (const Layer& layer : scene.layers) {
    for (const Circle& circle : layer.circles) {
      const Pixel centre = toPixel(camera, circle.centre);
      const double half =
          0.75 * std::max(circle.radius * camera.scale, static_cast<double>(circle.minimumRadius) * scale);
      taken.push_back({centre.x - half, centre.y - half, 2.0 * half, 2.0 * half});
    }
  }
  for (const Layer& layer : scene.layers) {
    for (const Label& label : layer.labels) {
      const Pixel anchor = toPixel(camera, label.at);
      if (misses(anchor, anchor, {0.0, 0.0, camera.width, camera.height})) continue;
      const double size = static_cast<double>(label.size) * scale;
      const double width = textWidth(label.text, size, Weight::semibold);
      const double around = label.around > 0.0 ? label.around * camera.scale + 3.0 * scale : 0.0;
      const double dx = std::copysign(std::max(std::fabs(static_cast<double>(label.dx) * scale), around), label.dx);
      const double dy = std::copysign(std::max(std::fabs(static_cast<double>(label.dy) * scale), around), label.dy);
      const double start = label.anchor == Anchor::left ? 0.0 : label.anchor == Anchor::centre ? 0.5 * width : width;
      // As asked; then mirrored about the anchor; then further out.
      const double line = 1.5 * size;
      const double down = -dy + 0.7 * size;
      const std::array<Pixel, 12> places{{{dx - start, dy},
                                          {-dx - width, dy},
                                          {dx - start, down},
                                          {-dx - width, down},
                                          {dx - start, dy - line},
                                          {dx - start, down + line},
                                          {-dx - width, dy - line},
                                          {-dx - width, down + line},
                                          {dx - start, dy - 2.0 * line},
                                          {dx - start, down + 2.0 * line},
                                          {-dx - width, dy - 2.0 * line},
                                          {-dx - width, down + 2.0 * line}}};
      const auto boxOf = [&](const Pixel& offset) {
        return Rect{anchor.x + offset.x - 2.0, anchor.y + offset.y - size, width + 4.0, 1.3 * size};
      };
      const auto covers = [](const Rect& box, std::span<const Rect> others) {
        return std::any_of(others.begin(), others.end(), [&](const Rect& r) { return overlap(r, box); });
      };
      const auto fits = [&](const Pixel& offset) {
        const Rect box = boxOf(offset);
        return box.x >= 0.0 && box.y >= 0.0 && box.x + box.width <= camera.width &&
               box.y + box.height <= camera.height && !covers(box, taken);
      };
      auto place = std::find_if(places.begin(), places.end(),
                                [&](const Pixel& offset) { return fits(offset) && !covers(boxOf(offset), avoid); });
      if (place == places.end()) place = std::find_if(places.begin(), places.end(), fits);
      if (place == places.end()) continue;
      taken.push_back(boxOf(*place));
      placed.push_back({&label, anchor + *place, width});
    }
  }
  return placed;
}

void drawPicture(const Scene& scene, const Camera& camera, const PictureLayout& layout, const PictureOptions& options,
                 Canvas& canvas) {
  const double s = options.scale;
  if (options.background) {
    const FilledRect all{{0.0, 0.0, layout.width, layout.height}, scene.theme.background};
    canvas.fillRects({&all, 1});
  }
  canvas.beginClip(layout.plot);
  Plotter plotter(camera, layout.plot, s, canvas);
  for (const Layer& layer : scene.layers) plotter.draw(layer);
  for (const PlacedLabel& placed : placeLabels(scene, camera, s)) {
    const Label& label = *placed.label;
    canvas.text({layout.plot.x + placed.at.x, layout.plot.y + placed.at.y}, label.text,
                {static_cast<double>(label.size) * s, Weight::semibold, label.color, label.halo, Anchor::left});
  }
  canvas.endClip();

  if (!options.title.empty()) {
    canvas.text({layout.plot.x, (kPadding + kTitleSize * 0.9) * s}, options.title,
                {kTitleSize * s, Weight::semibold, scene.theme.text, {0, 0, 0, 0}, Anchor::left});
  }
  if (options.legend) drawLegend(scene.legend, {layout.legend.x, layout.legend.y}, s, scene.theme, canvas);
  if (options.scaleBar) drawScaleBar(scene, camera, layout, s, canvas);
  double y = layout.plot.y + layout.plot.height + (options.scaleBar ? kScaleBarHeight * s : 0.0) + kCaptionLine * s;
  for (const std::string& line : layout.captionLines) {
    canvas.text({layout.plot.x, y}, line,
                {kCaptionSize * s, Weight::regular, scene.theme.textMuted, {0, 0, 0, 0}, Anchor::left});
    y += kCaptionLine * s;
  }
}

}  // namespace triscope
