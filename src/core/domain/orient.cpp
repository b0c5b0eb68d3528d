#include "core/domain/orient.h"

#include <algorithm>

#include "core/domain/outline.h"
#include "core/geometry/predicates.h"

namespace triscope {

namespace {

/// +1 for a counter-clockwise loop, -1 for a clockwise one: the turn at its leftmost (then lowest) point, exact.
int senseOf(const std::vector<Chord>& chords) {
  std::size_t first = 0;
  for (std::size_t i = 1; i < chords.size(); ++i) {
    if (leftOf(chords[i].a, chords[first].a)) first = i;
  }
  const std::size_t previous = (first + chords.size() - 1) % chords.size();
  return orient2d(chords[previous].a, chords[first].a, chords[first].b);
}

void turnRound(DomainDraft& draft, const Loop& loop) {
  const auto begin = static_cast<std::ptrdiff_t>(loop.firstCurve);
  const auto end = begin + static_cast<std::ptrdiff_t>(loop.curveCount);
  auto& curves = draft.domain.curves;
  for (std::ptrdiff_t c = begin; c < end; ++c) {
    const auto i = static_cast<std::size_t>(c);
    CurveSource& source = draft.sources[i];
    const auto points = std::max<std::size_t>(curves[i].knots.size(), 2);
    source.first = source.pointAt(static_cast<int>(points) - 1);
    source.step = -source.step;
    curves[i] = reversed(curves[i]);
  }
  std::reverse(curves.begin() + begin, curves.begin() + end);
  std::reverse(draft.sources.begin() + begin, draft.sources.begin() + end);
}

}  // namespace

Curve reversed(const Curve& curve) {
  Curve turned = curve;
  turned.a = curve.b;
  turned.b = curve.a;
  turned.startAngle = curve.startAngle + curve.sweptAngle;
  turned.sweptAngle = -curve.sweptAngle;
  std::reverse(turned.knots.begin(), turned.knots.end());
  std::reverse(turned.slopes.begin(), turned.slopes.end());
  std::reverse(turned.params.begin(), turned.params.end());
  for (Point& slope : turned.slopes) slope = -1.0 * slope;
  for (double& param : turned.params) param = 1.0 - param;
  return turned;
}

void orient(DomainDraft& draft) {
  Domain& domain = draft.domain;
  domain.bounds = {};
  for (std::uint32_t i = 0; i < domain.loops.size(); ++i) {
    const Loop& loop = domain.loops[i];
    const std::vector<Chord> chords = outlineOf(domain, i);
    for (const Chord& chord : chords) {
      domain.bounds.include(chord.a);
      domain.bounds.include(chord.b);
    }
    if (loop.role == LoopRole::chain || chords.empty()) continue;
    const int wanted = loop.role == LoopRole::outer ? 1 : -1;
    if (senseOf(chords) == -wanted) turnRound(draft, loop);
  }
}

}  // namespace triscope
