#include "render/sample_fill.h"

#include <algorithm>
#include <cmath>

namespace triscope {
namespace {

constexpr int kSamples = 4;    // across and down a pixel
constexpr int kBandRows = 32;  // pixels; keeps the samples of a band in the cache

// Horizontal extent of a triangle at a height; samples on a shared edge go to exactly one side because both
// triangles work the edge out from the same end.
struct Edge {
  Pixel low;
  double slope = 0.0;
};

Edge edgeOf(Pixel a, Pixel b) {
  if (a.y > b.y || (a.y == b.y && a.x > b.x)) std::swap(a, b);
  return {a, b.y > a.y ? (b.x - a.x) / (b.y - a.y) : 0.0};
}

double xAt(const Edge& edge, double y) { return edge.low.x + (y - edge.low.y) * edge.slope; }

class Band {
 public:
  Band(const PixelBox& clip, int row)
      : clip_(clip),
        top_(row),
        rows_(std::min(kBandRows, clip.y1 - row)),
        width_((clip.x1 - clip.x0) * kSamples),
        samples_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(rows_ * kSamples), Color{0, 0, 0, 0}) {}

  void add(Pixel a, Pixel b, Pixel c, Color color, bool hatched) {
    if (a.y > b.y) std::swap(a, b);
    if (b.y > c.y) std::swap(b, c);
    if (a.y > b.y) std::swap(a, b);
    const Edge whole = edgeOf(a, c);
    const Edge lower = edgeOf(a, b);
    const Edge upper = edgeOf(b, c);
    const int first = std::max(0, firstSample(a.y - top_));
    const int last = std::min(rows_ * kSamples, firstSample(c.y - top_));
    for (int s = first; s < last; ++s) {
      const double y = top_ + (s + 0.5) / kSamples;
      const double x0 = xAt(whole, y);
      const double x1 = y < b.y ? xAt(lower, y) : xAt(upper, y);
      const int from = std::max(0, firstSample(std::min(x0, x1) - clip_.x0));
      const int to = std::min(width_, firstSample(std::max(x0, x1) - clip_.x0));
      Color* const row = samples_.data() + static_cast<std::size_t>(s) * static_cast<std::size_t>(width_);
      for (int x = from; x < to; ++x) {
        if (hatched && !onStripe(x + clip_.x0 * kSamples, s + top_ * kSamples)) continue;
        row[x] = color;
      }
    }
  }

  void paint(Image& image) const {
    for (int row = 0; row < rows_; ++row) {
      for (int x = clip_.x0; x < clip_.x1; ++x) {
        // Average the samples with their alpha, then blend once.
        int red = 0, green = 0, blue = 0, alpha = 0;
        for (int s = 0; s < kSamples * kSamples; ++s) {
          const int sampleRow = row * kSamples + s / kSamples;
          const int sampleColumn = (x - clip_.x0) * kSamples + s % kSamples;
          const Color c = samples_[static_cast<std::size_t>(sampleRow) * static_cast<std::size_t>(width_) +
                                   static_cast<std::size_t>(sampleColumn)];
          red += c.r * c.a;
          green += c.g * c.a;
          blue += c.b * c.a;
          alpha += c.a;
        }
        if (alpha == 0) continue;
        const Color mean{static_cast<std::uint8_t>(red / alpha), static_cast<std::uint8_t>(green / alpha),
                         static_cast<std::uint8_t>(blue / alpha),
                         static_cast<std::uint8_t>((alpha + 8) / (kSamples * kSamples))};
        image.at(x, top_ + row) = blend(image.at(x, top_ + row), mean, 1.0f);
      }
    }
  }

 private:
  // Samples lie at (i + 1/2) / kSamples; the first at or after `offset`.
  static int firstSample(double offset) {
    const double at = std::ceil(offset * kSamples - 0.5);
    return static_cast<int>(std::clamp(at, -1.0e6, 1.0e6));
  }
  static bool onStripe(int x, int y) { return (x + y) % (6 * kSamples) < 5 * kSamples / 3; }

  PixelBox clip_;
  int top_;
  int rows_;
  int width_;
  std::vector<Color> samples_;
};

}  // namespace

void fillTriangles(Image& image, const PixelBox& clip, std::span<const Pixel> points, std::span<const Index3> triangles,
                   std::span<const Color> fills, bool hatched) {
  if (fills.empty() || clip.x1 <= clip.x0) return;
  for (int row = clip.y0; row < clip.y1; row += kBandRows) {
    Band band(clip, row);
    bool any = false;
    const double end = row + kBandRows;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const Pixel a = points[triangles[i][0]];
      const Pixel b = points[triangles[i][1]];
      const Pixel c = points[triangles[i][2]];
      if (std::max({a.y, b.y, c.y}) < row || std::min({a.y, b.y, c.y}) > end) continue;
      band.add(a, b, c, fills.size() > 1 ? fills[i] : fills[0], hatched);
      any = true;
    }
    if (any) band.paint(image);
  }
}

}  // namespace triscope
