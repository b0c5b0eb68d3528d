// A table of values as coloured cells over two axes, on any canvas.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/canvas.h"
#include "render/palette.h"

namespace triscope {

struct HeatAxis {
  std::string title;                // short: it stands beside the labels
  std::vector<std::string> labels;  // of the columns from the left, or of the rows from below
};

struct HeatCell {
  std::optional<double> value;  // nothing: not known yet
  std::string text;             // written into the cell where every cell's text fits
  bool crossed = false;         // marked as one to be wary of
};

struct HeatMap {
  HeatAxis across;
  HeatAxis up;
  std::vector<HeatCell> cells;  // column by column, each from below
  double low = 0.0;             // values at the ends of the colours
  double high = 0.0;
  std::optional<std::size_t> best;  // cell that is marked
  std::optional<glm::dvec2> here;   // place that is marked: (0, 0) is the middle of the first cell, (1, 0) of its right
  std::optional<std::size_t> under;   // cell that the mouse is on
  std::optional<std::size_t> chosen;  // cell that the keys are on
  bool faded = false;                 // what it shows holds no longer: pale, and without texts
};

/// Where the cells are, in pixels.
struct HeatGrid {
  Rect cells;
  std::size_t columns = 0;
  std::size_t rows = 0;
};

/// The cells as large as the room allows beside the labels, but no larger than reads well. `scale`: 1 at 100 %.
HeatGrid heatGrid(const HeatMap& map, Rect room, double scale);
/// On whole pixels, so that neighbours meet without a seam.
Rect cellRect(const HeatGrid& grid, std::size_t cell);
std::optional<std::size_t> cellAt(const HeatGrid& grid, Pixel at);

/// Dark at `low`, light at `high`; the middle where they are the same.
Color heatColor(const HeatMap& map, Scale colors, const Theme& theme, double value);
void drawHeatMap(const HeatMap& map, const HeatGrid& grid, Scale colors, double scale, const Theme& theme,
                 Canvas& canvas);
/// What the colours and the marks say: `title` and the texts at the ends of the colours, and the words for the marks
/// that there are.
struct HeatLegend {
  std::string title;
  std::string low;
  std::string high;
  std::string best;
  std::string here;
  std::string crossed;
  std::string chosen;
};
std::vector<LegendItem> legendOf(const HeatMap& map, const HeatLegend& words, Scale colors, const Theme& theme);

}  // namespace triscope
