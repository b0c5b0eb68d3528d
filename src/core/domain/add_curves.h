// From the points of a file to the curves of a loop.
#pragma once

#include <vector>

#include "core/domain/draft.h"
#include "core/domain/read_values.h"

namespace triscope {

/// A run of points of one loop, segment or piece.
struct PointRun {
  std::vector<Point> points;  // a closed run does not repeat its first point
  bool closed = false;
  ReadPlace place;
};

/// Refuses a run of fewer points than `fewest` (for `what`), or with neighbours at the same place.
Status checkRun(const PointRun& run, std::size_t fewest, std::string_view what);

/// One line for each edge.
void addLines(const PointRun& run, DomainDraft& draft);

/// One spline from corner to corner (indices, increasing); a closed run without corners is smooth everywhere.
/// Errors: neighbours too close together for the length of the run.
Status addSplines(const PointRun& run, const std::vector<int>& corners, DomainDraft& draft);

/// The arc through three points. Errors: they lie on one line.
Status addArc(const PointRun& run, DomainDraft& draft);

}  // namespace triscope
