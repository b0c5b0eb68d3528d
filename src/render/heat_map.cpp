#include "render/heat_map.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace triscope {
namespace {

constexpr double kLabelText = 12.5;  // sizes in pixels at 100 %
constexpr double kLine = 18.0;       // of the labels below
constexpr double kLabelGap = 7.0;
constexpr double kWidest = 120.0;  // of a cell
constexpr double kHighest = 44.0;
constexpr double kMark = 10.0;
constexpr double kSmallest = 10.0;  // of cells with lines between them
constexpr double kFaded = 0.75;     // part of the background

double widestOf(const std::vector<std::string>& texts) {
  double width = 0.0;
  for (const std::string& text : texts) width = std::max(width, textWidth(text, kLabelText));
  return width;
}

Color inkOn(Color fill) {
  constexpr Color dark = rgb(0x101418);
  constexpr Color light = rgb(0xFFFFFF);
  return contrast(fill, dark) > contrast(fill, light) ? dark : light;
}

void outline(Canvas& canvas, const Rect& r, const LineStyle& style) {
  canvas.stroke(
      {{{r.x, r.y}, {r.x + r.width, r.y}, {r.x + r.width, r.y + r.height}, {r.x, r.y + r.height}, {r.x, r.y}}, {0}},
      style);
}

LineStyle solid(Color color, double width) { return {color, static_cast<float>(width), Dash::solid, false}; }

Rect inset(const Rect& r, double by) { return {r.x + by, r.y + by, r.width - 2.0 * by, r.height - 2.0 * by}; }

Pixel middleOf(const Rect& r) { return {r.x + 0.5 * r.width, r.y + 0.5 * r.height}; }

double labelGutter(const HeatMap& map) {
  return textWidth(map.up.title, kLabelText, Weight::semibold) + kLabelGap + widestOf(map.up.labels) + kLabelGap;
}

/// Every how many labels one is written, so that they do not touch.
std::size_t stride(double room, double needed) {
  return room <= 0.0 ? 1 : std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(needed / room)));
}

bool onCell(const HeatMap& map) {
  return map.here && map.here->x == std::floor(map.here->x) && map.here->y == std::floor(map.here->y);
}

class Drawing {
 public:
  Drawing(const HeatMap& map, const HeatGrid& grid, Scale colors, double scale, const Theme& theme, Canvas& canvas)
      : map_(map), grid_(grid), colors_(colors), s_(scale), theme_(theme), canvas_(canvas) {}

  void cells() {
    std::vector<FilledRect> fills;
    for (std::size_t k = 0; k < map_.cells.size(); ++k) {
      const std::optional<double>& value = map_.cells[k].value;
      fills.push_back({cellRect(grid_, k), value ? heatColor(map_, colors_, theme_, *value) : theme_.background});
    }
    canvas_.fillRects(fills);
    separate();
    if (!map_.faded && textsFit())
      for (std::size_t k = 0; k < map_.cells.size(); ++k) text(fills[k], map_.cells[k].text);
    if (!map_.faded) {
      for (std::size_t k = 0; k < map_.cells.size(); ++k)
        if (map_.best != k) marks(k, fills[k]);
      if (map_.best) marks(*map_.best, fills[*map_.best]);
    }
    outline(canvas_, grid_.cells, solid(theme_.cellLine, s_));
  }

  void axes() {
    const Rect& all = grid_.cells;
    const double wide = all.width / static_cast<double>(grid_.columns);
    const double high = all.height / static_cast<double>(grid_.rows);
    const double below = all.y + all.height + 14.0 * s_;
    const double beside = all.x - kLabelGap * s_;
    const std::size_t columns = stride(wide, (widestOf(map_.across.labels) + kLabelGap) * s_);
    for (std::size_t i = 0; i < grid_.columns; i += columns)
      label({all.x + (static_cast<double>(i) + 0.5) * wide, below}, map_.across.labels[i], Anchor::centre);
    const std::size_t rows = stride(high, kLabelText * 1.15 * s_);
    for (std::size_t j = 0; j < grid_.rows; j += rows)
      label({beside, all.y + all.height - (static_cast<double>(j) + 0.5) * high + 0.36 * kLabelText * s_},
            map_.up.labels[j], Anchor::right);
    const double overhang = 0.5 * std::max(0.0, textWidth(map_.across.labels.front(), kLabelText) * s_ - wide);
    title({beside - overhang, below}, map_.across.title, Anchor::right);
    title({all.x - labelGutter(map_) * s_, all.y + 0.5 * all.height + 0.36 * kLabelText * s_}, map_.up.title,
          Anchor::left);
  }

  void here() {
    if (!map_.here) return;
    const double wide = grid_.cells.width / static_cast<double>(grid_.columns);
    const double high = grid_.cells.height / static_cast<double>(grid_.rows);
    const Pixel at{grid_.cells.x + (map_.here->x + 0.5) * wide,
                   grid_.cells.y + grid_.cells.height - (map_.here->y + 0.5) * high};
    const std::optional<std::size_t> cell = cellAt(grid_, at);
    if (onCell(map_) && cell) {
      // Half outside of the cell, so that its text stays clear.
      const Rect rect = cellRect(grid_, *cell);
      const double width = std::min(3.0 * s_, 0.2 * std::min(rect.width, rect.height));
      outline(canvas_, rect, solid(theme_.background, width + 2.0 * s_));
      outline(canvas_, rect, solid(theme_.selection, width));
      return;
    }
    canvas_.circle(at, 6.0 * s_, solid(theme_.background, 6.0 * s_));
    canvas_.circle(at, 6.0 * s_, solid(theme_.selection, 3.0 * s_));
  }

  /// A ring about the cell's border: dark and light, so that it is seen on any colour, and clear of the text.
  void chosen() {
    if (!map_.chosen) return;
    const Rect cell = cellRect(grid_, *map_.chosen);
    const double width = std::min(2.5 * s_, 0.08 * std::min(cell.width, cell.height));
    outline(canvas_, inset(cell, -width), solid(rgb(0x000000), width));
    outline(canvas_, inset(cell, width), solid(rgb(0x000000), width));
    outline(canvas_, cell, solid(rgb(0xFFFFFF), width));
  }

  void under() {
    if (map_.under) outline(canvas_, inset(cellRect(grid_, *map_.under), s_), solid(theme_.text, 2.0 * s_));
  }

 private:
  /// Lines between the cells, so that equal neighbours stay apart.
  void separate() {
    const Rect smallest = cellRect(grid_, 0);
    if (std::min(smallest.width, smallest.height) < kSmallest * s_) return;
    const Rect& all = grid_.cells;
    Paths lines;
    const auto line = [&lines](Pixel from, Pixel to) {
      lines.starts.push_back(static_cast<std::uint32_t>(lines.points.size()));
      lines.points.insert(lines.points.end(), {from, to});
    };
    for (std::size_t i = 1; i < grid_.columns; ++i) {
      const double x = cellRect(grid_, i * grid_.rows).x;
      line({x, all.y}, {x, all.y + all.height});
    }
    for (std::size_t j = 1; j < grid_.rows; ++j) {
      const double y = cellRect(grid_, j - 1).y;
      line({all.x, y}, {all.x + all.width, y});
    }
    if (!lines.starts.empty()) canvas_.stroke(lines, solid(theme_.surface, s_));
  }

  [[nodiscard]] bool textsFit() const {
    double width = 0.0;
    for (const HeatCell& cell : map_.cells) width = std::max(width, textWidth(cell.text, kLabelText));
    const Rect smallest = cellRect(grid_, 0);
    return (width + kLabelGap) * s_ <= smallest.width && (kLabelText + 1.0) * s_ <= smallest.height;
  }

  void text(const FilledRect& cell, const std::string& words) {
    const Pixel middle = middleOf(cell.rect);
    canvas_.text({middle.x, middle.y + 0.36 * kLabelText * s_}, words,
                 {kLabelText * s_, Weight::regular, inkOn(cell.fill), {0, 0, 0, 0}, Anchor::centre});
  }

  void marks(std::size_t k, const FilledRect& cell) {
    const double side = std::min(cell.rect.width, cell.rect.height);
    const bool inCorner = side >= 2.0 * kMark * s_;  // beside the text; else in the middle
    const Color ink = inkOn(cell.fill);
    const auto mark = [&](Shape shape, double size, bool atRight, Color rim) {
      const double in = 0.5 * size + 4.0 * s_;
      const Pixel corner{atRight ? cell.rect.x + cell.rect.width - in : cell.rect.x + in, cell.rect.y + in};
      const PlacedMark placed{inCorner ? corner : middleOf(cell.rect), static_cast<float>(size)};
      canvas_.marks({&placed, 1}, shape, ink, rim);
    };
    constexpr Color kNoRim{0, 0, 0, 0};
    if (map_.cells[k].crossed) mark(Shape::cross, std::min(kMark * s_, 0.6 * side), false, kNoRim);
    // There is one: it may be larger than its cell.
    if (map_.best == k) mark(Shape::diamond, kMark * s_, true, inCorner ? kNoRim : inkOn(ink));
  }

  void label(Pixel at, const std::string& words, Anchor anchor) {
    canvas_.text(at, words, {kLabelText * s_, Weight::regular, theme_.textMuted, {0, 0, 0, 0}, anchor});
  }

  void title(Pixel at, const std::string& words, Anchor anchor) {
    canvas_.text(at, words, {kLabelText * s_, Weight::semibold, theme_.text, {0, 0, 0, 0}, anchor});
  }

  const HeatMap& map_;
  const HeatGrid& grid_;
  Scale colors_;
  double s_;
  const Theme& theme_;
  Canvas& canvas_;
};

}  // namespace

HeatGrid heatGrid(const HeatMap& map, Rect room, double scale) {
  const std::size_t columns = map.across.labels.size();
  const std::size_t rows = map.up.labels.size();
  const double left = std::round(labelGutter(map) * scale);
  const double below = std::round(kLine * scale);
  const auto size = [scale](double available, std::size_t count, double most) {
    return std::round(std::clamp(available, 1.0, static_cast<double>(count) * most * scale));
  };
  const Rect cells{std::round(room.x) + left, std::round(room.y), size(room.width - left, columns, kWidest),
                   size(room.height - below, rows, kHighest)};
  return {cells, columns, rows};
}

Rect cellRect(const HeatGrid& grid, std::size_t cell) {
  const std::size_t column = cell / grid.rows;
  const std::size_t row = grid.rows - 1 - cell % grid.rows;  // from above
  const auto edge = [](double from, double length, std::size_t k, std::size_t count) {
    return std::round(from + length * static_cast<double>(k) / static_cast<double>(count));
  };
  const Rect& all = grid.cells;
  const double x = edge(all.x, all.width, column, grid.columns);
  const double y = edge(all.y, all.height, row, grid.rows);
  return {x, y, edge(all.x, all.width, column + 1, grid.columns) - x, edge(all.y, all.height, row + 1, grid.rows) - y};
}

std::optional<std::size_t> cellAt(const HeatGrid& grid, Pixel at) {
  const Rect& all = grid.cells;
  const double x = (at.x - all.x) / all.width;
  const double y = (at.y - all.y) / all.height;
  if (x < 0.0 || x >= 1.0 || y < 0.0 || y >= 1.0) return std::nullopt;
  const auto column = static_cast<std::size_t>(x * static_cast<double>(grid.columns));
  const auto row = static_cast<std::size_t>(y * static_cast<double>(grid.rows));
  return column * grid.rows + (grid.rows - 1 - row);
}

Color heatColor(const HeatMap& map, Scale colors, const Theme& theme, double value) {
  const double t = map.high > map.low ? (value - map.low) / (map.high - map.low) : 0.5;
  const Color color = scaleColor(colors, t);
  return map.faded ? mix(color, theme.surface, kFaded) : color;
}

void drawHeatMap(const HeatMap& map, const HeatGrid& grid, Scale colors, double scale, const Theme& theme,
                 Canvas& canvas) {
  if (grid.columns == 0 || grid.rows == 0) return;
  Drawing drawing(map, grid, colors, scale, theme, canvas);
  drawing.cells();
  drawing.axes();
  drawing.here();
  drawing.under();
  drawing.chosen();
}

std::vector<LegendItem> legendOf(const HeatMap& map, const HeatLegend& words, Scale colors, const Theme& theme) {
  using Sample = LegendItem::Sample;
  std::vector<LegendItem> legend;
  const auto item = [&legend](Sample sample, const std::string& label) -> LegendItem& {
    LegendItem& added = legend.emplace_back();
    added.sample = sample;
    added.label = label;
    return added;
  };
  LegendItem& ramp = item(Sample::ramp, words.title);
  constexpr int kSteps = 24;
  for (int i = 0; i < kSteps; ++i)
    ramp.ramp.push_back(heatColor(map, colors, theme, map.low + (i + 0.5) / kSteps * (map.high - map.low)));
  ramp.low = words.low;
  ramp.high = words.high;
  if (map.best) {
    LegendItem& best = item(Sample::mark, words.best);
    best.shape = Shape::diamond;
    best.fill = theme.text;
  }
  if (map.here) item(onCell(map) ? Sample::line : Sample::circle, words.here).line = solid(theme.selection, 3.0);
  if (map.chosen) item(Sample::line, words.chosen).line = {theme.text, 3.0f, Dash::solid, false};
  if (std::any_of(map.cells.begin(), map.cells.end(), [](const HeatCell& cell) { return cell.crossed; })) {
    LegendItem& crossed = item(Sample::mark, words.crossed);
    crossed.shape = Shape::cross;
    crossed.fill = theme.text;
  }
  return legend;
}

}  // namespace triscope
