// The legend as it is drawn beside a picture.
#pragma once

#include "render/canvas.h"

namespace triscope {

struct LegendSize {
  double width = 0.0;
  double height = 0.0;
};

LegendSize legendSize(const std::vector<LegendItem>& legend, double scale);
/// `at` is the upper left corner.
void drawLegend(const std::vector<LegendItem>& legend, Pixel at, double scale, const Theme& theme, Canvas& canvas);

}  // namespace triscope
