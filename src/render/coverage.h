// Exact area coverage of polygons on a pixel grid: what anti-aliased strokes, marks and glyphs are filled with.
//
// Each edge adds to every pixel it crosses the signed area between itself and the pixel's right side, and its signed
// height to all pixels further right (kept as a running sum along the row). Polygons that turn the same way add up,
// so the union of many is drawn with no seam between them; what exceeds 1 is cut off.
#pragma once

#include <span>
#include <vector>

#include "render/image.h"
#include "render/pixel.h"

namespace triscope {

class Coverage {
 public:
  Coverage(int width, int height);

  /// A closed polygon, turned counter-clockwise first, so that polygons never cancel out.
  void addPolygon(std::span<const Pixel> polygon);
  /// A closed contour as it turns: inner contours that turn the other way are holes.
  void addContour(std::span<const Pixel> contour);
  /// Blends the colour over the image where covered, inside [x0, x1) × [y0, y1), and starts afresh.
  void paint(Image& image, Color color, int x0, int y0, int x1, int y1);

 private:
  void addEdge(Pixel a, Pixel b, float sign);
  void addRowPiece(int row, double xa, double xb, float height);

  int width_;
  int height_;
  std::size_t stride_;
  std::vector<float> sums_;
  int top_;  // rows that hold anything
  int bottom_;
};

}  // namespace triscope
