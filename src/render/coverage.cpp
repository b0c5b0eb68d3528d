#include "render/coverage.h"

#include <algorithm>
#include <cmath>

namespace triscope {

Coverage::Coverage(int width, int height)
    : width_(width),
      height_(height),
      stride_(static_cast<std::size_t>(width) + 2),
      sums_(stride_ * static_cast<std::size_t>(height), 0.0f),
      top_(height),
      bottom_(0) {}

void Coverage::addPolygon(std::span<const Pixel> polygon) {
  double doubled = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) doubled += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  const float sign = doubled < 0.0 ? -1.0f : 1.0f;
  for (std::size_t i = 0; i < polygon.size(); ++i) addEdge(polygon[i], polygon[(i + 1) % polygon.size()], sign);
}

void Coverage::addContour(std::span<const Pixel> contour) {
  for (std::size_t i = 0; i < contour.size(); ++i) addEdge(contour[i], contour[(i + 1) % contour.size()], 1.0f);
}

void Coverage::addEdge(Pixel a, Pixel b, float sign) {
  if (a.y == b.y) return;
  if (a.y > b.y) {
    std::swap(a, b);
    sign = -sign;
  }
  const double slope = (b.x - a.x) / (b.y - a.y);
  double y = a.y;
  double x = a.x;
  if (y < 0.0) {
    x -= y * slope;
    y = 0.0;
  }
  const double end = std::min(b.y, static_cast<double>(height_));
  if (!(y < end)) return;
  const int firstRow = static_cast<int>(y);
  const int lastRow = std::min(height_ - 1, static_cast<int>(std::ceil(end)) - 1);
  top_ = std::min(top_, firstRow);
  bottom_ = std::max(bottom_, lastRow + 1);
  for (int row = firstRow; row <= lastRow; ++row) {
    const double nextY = std::min(static_cast<double>(row) + 1.0, end);
    const double nextX = x + (nextY - y) * slope;
    addRowPiece(row, x, nextX, sign * static_cast<float>(nextY - y));
    x = nextX;
    y = nextY;
  }
}

// One edge within one row, from xa to xb, of signed height `height`.
void Coverage::addRowPiece(int row, double xa, double xb, float height) {
  float* const sums = sums_.data() + stride_ * static_cast<std::size_t>(row);
  const double most = static_cast<double>(width_);
  const double left = std::clamp(std::min(xa, xb), 0.0, most);
  const double right = std::clamp(std::max(xa, xb), 0.0, most);
  const auto first = static_cast<std::size_t>(left);
  const auto last = static_cast<std::size_t>(right);
  if (first == last) {
    const auto covered = static_cast<float>(static_cast<double>(first) + 1.0 - 0.5 * (left + right));
    sums[first] += height * covered;
    sums[first + 1] += height * (1.0f - covered);
    return;
  }
  // The share of the height that falls to each pixel, and the area to the right of the edge within it.
  const double perPixel = 1.0 / (right - left);
  double x = left;
  for (std::size_t i = first; i <= last; ++i) {
    const double nextX = std::min(static_cast<double>(i) + 1.0, right);
    const auto share = static_cast<float>((nextX - x) * perPixel) * height;
    const auto covered = static_cast<float>(static_cast<double>(i) + 1.0 - 0.5 * (x + nextX));
    sums[i] += share * covered;
    sums[i + 1] += share * (1.0f - covered);
    x = nextX;
  }
}

void Coverage::paint(Image& image, Color color, int x0, int y0, int x1, int y1) {
  for (int row = top_; row < bottom_; ++row) {
    float* const sums = sums_.data() + stride_ * static_cast<std::size_t>(row);
    if (row >= y0 && row < y1) {
      float sum = 0.0f;
      for (int x = 0; x < x1; ++x) {
        sum += sums[x];
        if (x < x0) continue;
        const float covered = std::min(std::fabs(sum), 1.0f);
        if (covered > 0.002f) image.at(x, row) = blend(image.at(x, row), color, covered);
      }
    }
    std::fill(sums, sums + stride_, 0.0f);
  }
  top_ = height_;
  bottom_ = 0;
}

}  // namespace triscope
