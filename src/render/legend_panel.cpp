#include "render/legend_panel.h"

#include <algorithm>

namespace triscope {
namespace {

using Sample = LegendItem::Sample;

constexpr double kText = 12.5;
constexpr double kRow = 20.0;
constexpr double kRampRow = 48.0;
constexpr double kRampWidth = 170.0;
constexpr double kSampleWidth = 26.0;
constexpr double kGap = 10.0;  // between sample and label, and between label and value
constexpr double kSmall = 11.0;

double rowHeight(const LegendItem& item) { return item.sample == Sample::ramp ? kRampRow : kRow; }

double rowWidth(const LegendItem& item) {
  if (item.sample == Sample::ramp) {
    return std::max({kRampWidth, textWidth(item.label, kText),
                     textWidth(item.low, kSmall) + textWidth(item.high, kSmall) + 2.0 * kGap});
  }
  if (item.sample == Sample::heading) return textWidth(item.label, kText, Weight::semibold);
  const double value = item.value.empty() ? 0.0 : kGap * 1.6 + textWidth(item.value, kText);
  return kSampleWidth + kGap + textWidth(item.label, kText) + value;
}

class LegendPainter {
 public:
  LegendPainter(double scale, double width, const Theme& theme, Canvas& canvas)
      : s_(scale), width_(width), theme_(theme), canvas_(canvas) {}

  void draw(const LegendItem& item, Pixel at) {
    if (item.sample == Sample::ramp) {
      drawRamp(item, at);
      return;
    }
    const double baseline = at.y + 14.0 * s_;
    if (item.sample == Sample::heading) {
      text({at.x, baseline}, item.label, kText, theme_.text, Anchor::left, Weight::semibold);
      return;
    }
    drawSample(item, {at.x, at.y + 0.5 * kRow * s_});
    text({at.x + (kSampleWidth + kGap) * s_, baseline}, item.label, kText, theme_.text, Anchor::left);
    if (!item.value.empty()) text({at.x + width_, baseline}, item.value, kText, theme_.textMuted, Anchor::right);
  }

 private:
  void text(Pixel at, const std::string& what, double size, Color color, Anchor anchor,
            Weight weight = Weight::regular) {
    canvas_.text(at, what, {size * s_, weight, color, {0, 0, 0, 0}, anchor});
  }

  [[nodiscard]] LineStyle scaled(LineStyle style) const {
    style.width *= static_cast<float>(s_);
    return style;
  }

  void drawSample(const LegendItem& item, Pixel middle) {
    const double w = kSampleWidth * s_;
    const Pixel centre{middle.x + 0.5 * w, middle.y};
    const LineStyle hairline{theme_.cellLine, static_cast<float>(0.8 * s_), Dash::solid, false};
    const Rect swatch{middle.x + 3.0 * s_, middle.y - 6.5 * s_, w - 6.0 * s_, 13.0 * s_};
    switch (item.sample) {
      case Sample::line:
        canvas_.stroke({{{middle.x, middle.y}, {middle.x + w, middle.y}}, {0}}, scaled(item.line));
        break;
      case Sample::circle:
        canvas_.circle(centre, 7.5 * s_, scaled(item.line));
        break;
      case Sample::mark: {
        const PlacedMark mark{centre, static_cast<float>(8.0 * s_)};
        canvas_.marks({&mark, 1}, item.shape, item.fill, {0, 0, 0, 0});
        break;
      }
      case Sample::fill: {
        const FilledRect rect{swatch, item.fill};
        canvas_.fillRects({&rect, 1});
        outline(swatch, hairline);
        break;
      }
      case Sample::hatch: {
        const std::array<Pixel, 4> corners{{{swatch.x, swatch.y},
                                            {swatch.x + swatch.width, swatch.y},
                                            {swatch.x + swatch.width, swatch.y + swatch.height},
                                            {swatch.x, swatch.y + swatch.height}}};
        const std::array<Index3, 2> halves{{{0, 1, 2}, {0, 2, 3}}};
        canvas_.fillTriangles(corners, halves, {&item.fill, 1}, true);
        outline(swatch, {item.fill, static_cast<float>(1.4 * s_), Dash::solid, false});
        break;
      }
      case Sample::none:
      case Sample::heading:
      case Sample::ramp:
        break;
    }
  }

  void outline(const Rect& r, const LineStyle& style) {
    canvas_.stroke(
        {{{r.x, r.y}, {r.x + r.width, r.y}, {r.x + r.width, r.y + r.height}, {r.x, r.y + r.height}, {r.x, r.y}}, {0}},
        style);
  }

  void drawRamp(const LegendItem& item, Pixel at) {
    text({at.x, at.y + 13.0 * s_}, item.label, kText, theme_.text, Anchor::left, Weight::semibold);
    const Rect bar{at.x, at.y + 19.0 * s_, kRampWidth * s_, 11.0 * s_};
    std::vector<FilledRect> rects;
    rects.reserve(item.ramp.size());
    const double step = bar.width / static_cast<double>(std::max<std::size_t>(1, item.ramp.size()));
    for (std::size_t i = 0; i < item.ramp.size(); ++i) {
      rects.push_back({{bar.x + step * static_cast<double>(i), bar.y, step, bar.height}, item.ramp[i]});
    }
    canvas_.fillRects(rects);
    outline(bar, {theme_.cellLine, static_cast<float>(0.8 * s_), Dash::solid, false});
    const double below = bar.y + bar.height + 12.0 * s_;
    text({bar.x, below}, item.low, kSmall, theme_.textMuted, Anchor::left);
    text({bar.x + std::max(bar.width, 0.0), below}, item.high, kSmall, theme_.textMuted, Anchor::right);
  }

  double s_;
  double width_;
  const Theme& theme_;
  Canvas& canvas_;
};

}  // namespace

LegendSize legendSize(const std::vector<LegendItem>& legend, double scale) {
  LegendSize size;
  for (const LegendItem& item : legend) {
    size.width = std::max(size.width, rowWidth(item));
    size.height += rowHeight(item);
  }
  return {size.width * scale, size.height * scale};
}

void drawLegend(const std::vector<LegendItem>& legend, Pixel at, double scale, const Theme& theme, Canvas& canvas) {
  LegendPainter panel(scale, legendSize(legend, scale).width, theme, canvas);
  for (const LegendItem& item : legend) {
    panel.draw(item, at);
    at.y += rowHeight(item) * scale;
  }
}

}  // namespace triscope
