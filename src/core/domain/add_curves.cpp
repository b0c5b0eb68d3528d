#include "core/domain/add_curves.h"

#include <fmt/format.h>

#include "core/domain/arc.h"
#include "core/domain/spline.h"

namespace triscope {

namespace {

Error complaintAt(const PointRun& run, std::size_t point, std::string message, std::string hint) {
  Error error = complaint(run.place, std::move(message), std::move(hint));
  error.point = static_cast<int>(point);
  error.at = run.points[point];
  return error;
}

void add(DomainDraft& draft, Curve curve, CurveSource source) {
  draft.domain.curves.push_back(std::move(curve));
  draft.sources.push_back(source);
}

CurveSource sourceOf(const PointRun& run, std::size_t first) {
  return {static_cast<int>(first), 1, static_cast<int>(run.points.size()), run.place.piece};
}

}  // namespace

Status checkRun(const PointRun& run, std::size_t fewest, std::string_view what) {
  const std::size_t count = run.points.size();
  if (count < fewest) {
    const std::string message = fmt::format("only {} different point{}", count, count == 1 ? "" : "s");
    const std::string hint = fmt::format("{} needs at least {}", what, fewest);
    return count == 0 ? complaint(run.place, "no points", hint) : complaintAt(run, 0, message, hint);
  }
  for (std::size_t i = 0; i + 1 < count; ++i) {
    if (run.points[i] == run.points[i + 1]) {
      return complaintAt(run, i + 1, fmt::format("point {} repeats point {}", i + 1, i), "remove one of the two");
    }
  }
  if (run.closed && run.points.front() == run.points.back()) {
    return complaintAt(run, count - 1, fmt::format("point {} repeats point 0 once more", count - 1), "remove it");
  }
  return success();
}

void addLines(const PointRun& run, DomainDraft& draft) {
  const std::size_t count = run.points.size();
  for (std::size_t i = 0; i + (run.closed ? 0 : 1) < count; ++i) {
    add(draft, {.kind = CurveKind::line, .a = run.points[i], .b = run.points[(i + 1) % count]}, sourceOf(run, i));
  }
}

Status addSplines(const PointRun& run, const std::vector<int>& corners, DomainDraft& draft) {
  std::vector<Point> around = run.points;
  if (run.closed) around.push_back(around.front());
  if (const int close = tooCloseForSpline(around); close >= 0) {
    const auto first = static_cast<std::size_t>(close);
    return complaintAt(
        run, first, fmt::format("the next point is too close for a spline of this length"),
        fmt::format("keep neighbours further apart than {} of the length, or make a corner here", kShortestSpan));
  }
  if (run.closed && corners.empty()) {
    add(draft, makeClosedSpline(run.points), sourceOf(run, 0));
    return success();
  }
  const auto count = static_cast<int>(run.points.size());
  std::vector<int> stops = corners;
  if (run.closed) {
    stops.push_back(corners.front() + count);
  } else {
    if (stops.empty() || stops.front() != 0) stops.insert(stops.begin(), 0);
    if (stops.back() != count - 1) stops.push_back(count - 1);
  }
  for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
    std::vector<Point> points;
    for (int k = stops[i]; k <= stops[i + 1]; ++k) points.push_back(run.points[static_cast<std::size_t>(k % count)]);
    add(draft, makeSpline(std::move(points)), sourceOf(run, static_cast<std::size_t>(stops[i])));
  }
  return success();
}

Status addArc(const PointRun& run, DomainDraft& draft) {
  auto arc = arcThrough(run.points[0], run.points[1], run.points[2]);
  if (!arc)
    return complaintAt(run, 1, "the three points of the arc lie on one line",
                       "use a piece of kind \"line\", or for a whole circle a loop of kind \"circle\"");
  CurveSource source = sourceOf(run, 0);
  source.step = 2;  // from point 0 to point 2
  add(draft, std::move(*arc), source);
  return success();
}

}  // namespace triscope
