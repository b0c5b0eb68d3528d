#include "core/domain/outline.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/trig.h"

namespace triscope {

namespace {

constexpr double kChordTurn = trig::kDegree;
constexpr double kMostChords = 1024.0;  // of one arc or spline span

int chordsFor(double turn) {
  return static_cast<int>(std::min(std::max(std::ceil(std::fabs(turn) / kChordTurn), 1.0), kMostChords));
}

void appendSteps(std::vector<double>& params, double from, double to, int count) {
  for (int i = 1; i < count; ++i) params.push_back(from + (to - from) * (static_cast<double>(i) / count));
  params.push_back(to);
}

}  // namespace

std::vector<double> sampleParams(const Curve& curve) {
  std::vector<double> params{0.0};
  switch (curve.kind) {
    case CurveKind::line:
      params.push_back(1.0);
      break;
    case CurveKind::arc:
      appendSteps(params, 0.0, 1.0, chordsFor(curve.sweptAngle));
      break;
    case CurveKind::spline:
      for (std::size_t k = 0; k + 1 < curve.knots.size(); ++k) {
        const Point chord = curve.knots[k + 1] - curve.knots[k];
        const double turn = std::fabs(trig::angleBetween(curve.slopes[k], chord)) +
                            std::fabs(trig::angleBetween(chord, curve.slopes[k + 1]));
        appendSteps(params, curve.params[k], curve.params[k + 1], chordsFor(turn));
      }
      break;
  }
  return params;
}

std::vector<Chord> outlineOf(const Domain& domain, std::uint32_t loop) {
  std::vector<Chord> chords;
  const Loop& run = domain.loops[loop];
  for (std::uint32_t c = run.firstCurve; c < run.firstCurve + run.curveCount; ++c) {
    const Curve& curve = domain.curves[c];
    std::int32_t knot = 0;
    Chord chord{.a = curve.a, .b = curve.a, .loop = loop, .curve = c};
    for (const double t : sampleParams(curve)) {
      const auto next = static_cast<std::size_t>(knot) + 1;
      if (next + 1 < curve.params.size() && curve.params[next] <= chord.t0) ++knot;
      const Point p = pointAt(curve, t);
      if (p == chord.a) continue;
      chord.b = p;
      chord.t1 = t;
      chord.knot = knot;
      chords.push_back(chord);
      chord.a = p;
      chord.t0 = t;
    }
    // The exact end may coincide with the sample before it; then that sample is the end.
    if (!chords.empty() && chords.back().curve == c) chords.back().t1 = 1.0;
  }
  return chords;
}

}  // namespace triscope
