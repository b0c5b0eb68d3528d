#include "core/domain/spline.h"

namespace triscope {

namespace {

/// Widths of the spans (chord lengths) and the slopes of the chords.
struct Chords {
  std::vector<double> width;
  std::vector<Point> slope;
  double total = 0.0;
};

Chords chordsOf(const std::vector<Point>& points) {
  Chords chords;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double width = distance(points[i], points[i + 1]);
    chords.width.push_back(width);
    chords.slope.push_back((1.0 / width) * (points[i + 1] - points[i]));
    chords.total += width;
  }
  return chords;
}

/// Solves a diagonally dominant tridiagonal system in place: right becomes the solution.
template <class Value>
void solveTridiagonal(const std::vector<double>& lower, std::vector<double> diagonal, const std::vector<double>& upper,
                      std::vector<Value>& right) {
  const std::size_t n = diagonal.size();
  for (std::size_t i = 1; i < n; ++i) {
    const double factor = lower[i] / diagonal[i - 1];
    diagonal[i] -= factor * upper[i - 1];
    right[i] = right[i] - factor * right[i - 1];
  }
  right[n - 1] = (1.0 / diagonal[n - 1]) * right[n - 1];
  for (std::size_t i = n - 1; i-- > 0;) right[i] = (1.0 / diagonal[i]) * (right[i] - upper[i] * right[i + 1]);
}

/// Second derivatives at the knots of an open spline whose first and last spans are parabolas.
std::vector<Point> openBends(const Chords& chords) {
  const std::vector<double>& h = chords.width;
  const std::size_t inner = h.size() - 1;
  std::vector<double> lower(inner), diagonal(inner), upper(inner);
  std::vector<Point> bends(inner);
  for (std::size_t i = 0; i < inner; ++i) {
    lower[i] = h[i];
    diagonal[i] = 2.0 * (h[i] + h[i + 1]);
    upper[i] = h[i + 1];
    bends[i] = 6.0 * (chords.slope[i + 1] - chords.slope[i]);
  }
  diagonal.front() += h.front();
  diagonal.back() += h.back();
  solveTridiagonal(lower, diagonal, upper, bends);
  bends.insert(bends.begin(), bends.front());
  bends.push_back(bends.back());
  return bends;
}

/// Second derivatives at the knots of a closed spline, the first again at the end. The corners of the cyclic
/// matrix are taken out as a correction of rank one (Sherman and Morrison).
std::vector<Point> closedBends(const Chords& chords) {
  const std::vector<double>& h = chords.width;
  const std::size_t n = h.size();
  std::vector<double> lower(n), diagonal(n), upper(n), correction(n, 0.0);
  std::vector<Point> bends(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t previous = (i + n - 1) % n;
    lower[i] = h[previous];
    diagonal[i] = 2.0 * (h[previous] + h[i]);
    upper[i] = h[i];
    bends[i] = 6.0 * (chords.slope[i] - chords.slope[previous]);
  }
  const double corner = h[n - 1];
  const double pivot = -diagonal[0];
  diagonal[0] -= pivot;
  diagonal[n - 1] -= corner * corner / pivot;
  correction[0] = pivot;
  correction[n - 1] = corner;
  solveTridiagonal(lower, diagonal, upper, bends);
  solveTridiagonal(lower, diagonal, upper, correction);
  const double share = corner / pivot;
  const double scale = 1.0 / (1.0 + correction[0] + share * correction[n - 1]);
  const Point excess = scale * (bends[0] + share * bends[n - 1]);
  for (std::size_t i = 0; i < n; ++i) bends[i] = bends[i] - correction[i] * excess;
  bends.push_back(bends.front());
  return bends;
}

/// The curve through knots with given second derivatives with respect to chord length.
Curve assemble(std::vector<Point> knots, const Chords& chords, const std::vector<Point>& bends) {
  Curve curve{.kind = CurveKind::spline, .a = knots.front(), .b = knots.back()};
  const std::size_t spans = chords.width.size();
  double reached = 0.0;
  for (std::size_t i = 0; i < spans; ++i) {
    curve.params.push_back(reached / chords.total);
    const double h = chords.width[i];
    curve.slopes.push_back(chords.total * (chords.slope[i] - (h / 6.0) * (2.0 * bends[i] + bends[i + 1])));
    reached += h;
  }
  curve.params.push_back(1.0);
  const double h = chords.width[spans - 1];
  curve.slopes.push_back(chords.total *
                         (chords.slope[spans - 1] + (h / 6.0) * (bends[spans - 1] + 2.0 * bends[spans])));
  curve.knots = std::move(knots);
  return curve;
}

}  // namespace

int tooCloseForSpline(const std::vector<Point>& points) {
  double total = 0.0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) total += distance(points[i], points[i + 1]);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    if (!(distance(points[i], points[i + 1]) > kShortestSpan * total)) return static_cast<int>(i);
  }
  return -1;
}

Curve makeSpline(std::vector<Point> points) {
  if (points.size() == 2) return {.kind = CurveKind::line, .a = points[0], .b = points[1]};
  const Chords chords = chordsOf(points);
  return assemble(std::move(points), chords, openBends(chords));
}

Curve makeClosedSpline(std::vector<Point> points) {
  points.push_back(points.front());
  const Chords chords = chordsOf(points);
  return assemble(std::move(points), chords, closedBends(chords));
}

}  // namespace triscope
