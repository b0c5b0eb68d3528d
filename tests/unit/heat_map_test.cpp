// The heat map's cells: where they are, which one a point is in, and how they are coloured.
#include "render/heat_map.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace triscope::heat_map_test {
namespace {

HeatMap map(std::size_t columns, std::size_t rows) {
  HeatMap made;
  made.across.title = "x";
  made.up.title = "y";
  for (std::size_t i = 0; i < columns; ++i) made.across.labels.push_back(std::to_string(i));
  for (std::size_t j = 0; j < rows; ++j) made.up.labels.push_back(std::to_string(j));
  made.low = 0.0;
  made.high = static_cast<double>(columns * rows);
  for (std::size_t k = 0; k < columns * rows; ++k)
    made.cells.push_back({static_cast<double>(k), std::to_string(k), false});
  return made;
}

/// What was drawn.
struct Drawn {
  std::vector<FilledRect> rects;
  std::vector<std::string> texts;
  std::vector<Shape> shapes;
  std::vector<Color> strokes;
  std::size_t circles = 0;
  [[nodiscard]] std::ptrdiff_t count(const std::string& words) const {
    return std::count(texts.begin(), texts.end(), words);
  }
};

class NotingCanvas : public Canvas {
 public:
  explicit NotingCanvas(Drawn& out) : out_(out) {}
  void beginClip(Rect) override {}
  void endClip() override {}
  void fillRects(std::span<const FilledRect> more) override {
    out_.rects.insert(out_.rects.end(), more.begin(), more.end());
  }
  void fillTriangles(std::span<const Pixel>, std::span<const Index3>, std::span<const Color>, bool) override {}
  void stroke(const Paths&, const LineStyle& style) override { out_.strokes.push_back(style.color); }
  void circle(Pixel, double, const LineStyle&) override { ++out_.circles; }
  void marks(std::span<const PlacedMark> more, Shape shape, Color, Color) override {
    out_.shapes.insert(out_.shapes.end(), more.size(), shape);
  }
  void text(Pixel, std::string_view words, const TextStyle&) override { out_.texts.emplace_back(words); }

 private:
  Drawn& out_;
};

Drawn drawn(const HeatMap& map, Rect room, double scale = 1.0) {
  Drawn out;
  NotingCanvas canvas(out);
  drawHeatMap(map, heatGrid(map, room, scale), Scale::cividis, scale, themeOf(ThemeKind::light), canvas);
  return out;
}

TEST(HeatMap, CellsCoverTheGridWithoutSeamsAndFromBelow) {
  for (const double scale : {0.75, 1.0, 1.5, 2.0, 3.0}) {
    for (const auto& [columns, rows] : {std::pair{5, 6}, std::pair{1, 1}, std::pair{40, 7}, std::pair{3, 40}}) {
      const HeatMap made = map(static_cast<std::size_t>(columns), static_cast<std::size_t>(rows));
      const HeatGrid grid = heatGrid(made, {13.4, 7.7, 611.0, 188.0}, scale);
      double area = 0.0;
      for (std::size_t k = 0; k < made.cells.size(); ++k) {
        const Rect cell = cellRect(grid, k);
        area += cell.width * cell.height;
        EXPECT_EQ(cellAt(grid, {cell.x + 0.5 * cell.width, cell.y + 0.5 * cell.height}), k);
        const bool lowest = k % grid.rows == 0;
        if (!lowest) {
          EXPECT_EQ(cell.y + cell.height, cellRect(grid, k - 1).y);
        } else if (k >= grid.rows) {
          const Rect left = cellRect(grid, k - grid.rows);
          EXPECT_EQ(left.x + left.width, cell.x);
        }
      }
      EXPECT_DOUBLE_EQ(area, grid.cells.width * grid.cells.height);
      EXPECT_LE(grid.cells.x + grid.cells.width, 13.4 + 611.0 + 1.0);
      EXPECT_LE(grid.cells.y + grid.cells.height, 7.7 + 188.0);
    }
  }
}

TEST(HeatMap, NothingIsUnderAPointBesideTheCells) {
  const HeatMap made = map(5, 6);
  const HeatGrid grid = heatGrid(made, {0, 0, 600, 200}, 1.0);
  const Rect& all = grid.cells;
  EXPECT_EQ(cellAt(grid, {all.x - 1.0, all.y + 1.0}), std::nullopt);
  EXPECT_EQ(cellAt(grid, {all.x + all.width, all.y + 1.0}), std::nullopt);
  EXPECT_EQ(cellAt(grid, {all.x + 1.0, all.y - 1.0}), std::nullopt);
  EXPECT_EQ(cellAt(grid, {all.x + 1.0, all.y + all.height}), std::nullopt);
  EXPECT_EQ(cellAt(grid, {all.x + 1.0, all.y + all.height - 1.0}), 0u);
  EXPECT_EQ(cellAt(grid, {all.x + all.width - 1.0, all.y + 1.0}), 29u);
}

TEST(HeatMap, ColoursFollowTheScale) {
  HeatMap made = map(2, 2);
  const Theme& theme = themeOf(ThemeKind::dark);
  EXPECT_EQ(heatColor(made, Scale::cividis, theme, 0.0), scaleColor(Scale::cividis, 0.0));
  EXPECT_EQ(heatColor(made, Scale::cividis, theme, 4.0), scaleColor(Scale::cividis, 1.0));
  EXPECT_EQ(heatColor(made, Scale::viridis, theme, 1.0), scaleColor(Scale::viridis, 0.25));
  made.high = made.low;
  EXPECT_EQ(heatColor(made, Scale::cividis, theme, made.low), scaleColor(Scale::cividis, 0.5));
  made.faded = true;
  EXPECT_NE(heatColor(made, Scale::cividis, theme, made.low), scaleColor(Scale::cividis, 0.5));
}

TEST(HeatMap, TextsAreWrittenWhereAllFit) {
  HeatMap made = map(2, 2);
  for (HeatCell& cell : made.cells) cell.text = "v" + cell.text;
  EXPECT_EQ(drawn(made, {0, 0, 400, 200}).count("v3"), 1);
  EXPECT_EQ(drawn(made, {0, 0, 70, 200}).count("v3"), 0) << "too narrow";
  EXPECT_EQ(drawn(made, {0, 0, 400, 40}).count("v3"), 0) << "too low";
  made.cells[0].text = "one that is much too long for it to be written there";
  EXPECT_EQ(drawn(made, {0, 0, 400, 200}).count("v3"), 0) << "another's does not fit";
}

TEST(HeatMap, LabelsThatWouldTouchAreLeftOut) {
  const Drawn wide = drawn(map(10, 2), {0, 0, 1200, 200});
  for (int i = 0; i < 10; ++i) EXPECT_GE(wide.count(std::to_string(i)), 1) << i;
  HeatMap made = map(40, 2);
  for (std::string& label : made.across.labels) label = "0." + label;
  const Drawn narrow = drawn(made, {0, 0, 300, 200});
  EXPECT_EQ(narrow.count("0.0"), 1);
  EXPECT_EQ(narrow.count("0.1"), 0);
  EXPECT_EQ(narrow.count("x"), 1);
  EXPECT_EQ(narrow.count("y"), 1);
}

TEST(HeatMap, MarksTheBestThePlaceAndWhatIsCrossed) {
  HeatMap made = map(3, 3);
  made.best = 4;
  made.cells[2].crossed = true;
  made.here = Pixel{1.0, 2.0};
  Drawn canvas = drawn(made, {0, 0, 400, 200});
  EXPECT_EQ(canvas.shapes, (std::vector<Shape>{Shape::cross, Shape::diamond}));
  EXPECT_EQ(canvas.circles, 0u);
  const Color chosen = themeOf(ThemeKind::light).selection;
  EXPECT_EQ(std::count(canvas.strokes.begin(), canvas.strokes.end(), chosen), 1) << "round the cell";
  const Drawn small = drawn(made, {0, 0, 60, 60});
  EXPECT_EQ(small.shapes, canvas.shapes) << "in small cells too";
  made.here = Pixel{1.0, 1.5};  // between two cells
  EXPECT_EQ(drawn(made, {0, 0, 400, 200}).circles, 2u);
}

TEST(HeatMap, FadedShowsNoValues) {
  HeatMap made = map(2, 2);
  made.best = 1;
  made.faded = true;
  for (HeatCell& cell : made.cells) cell.text = "v" + cell.text;
  const Drawn canvas = drawn(made, {0, 0, 400, 200});
  EXPECT_EQ(canvas.count("v1"), 0);
  EXPECT_TRUE(canvas.shapes.empty());
  EXPECT_EQ(canvas.count("1"), 2) << "the labels stay";
}

TEST(HeatMap, LegendSaysWhatIsThere) {
  HeatMap made = map(2, 2);
  const HeatLegend words{"figure", "0", "4", "best", "here", "crossed", "chosen"};
  const auto labels = [&] {
    std::vector<std::string> list;
    for (const LegendItem& item : legendOf(made, words, Scale::cividis, themeOf(ThemeKind::light)))
      list.push_back(item.label);
    return list;
  };
  EXPECT_EQ(labels(), (std::vector<std::string>{"figure"}));
  made.here = Pixel{0.5, 0.0};
  EXPECT_EQ(labels(), (std::vector<std::string>{"figure", "here"}));
  made.best = 0;
  made.cells[1].crossed = true;
  EXPECT_EQ(labels(), (std::vector<std::string>{"figure", "best", "here", "crossed"}));
  made.chosen = 1;
  EXPECT_EQ(labels(), (std::vector<std::string>{"figure", "best", "here", "chosen", "crossed"}));
}

}  // namespace
}  // namespace triscope::heat_map_test
