// A domain on its way from the file, with the memory of where in the file each curve came from.
#pragma once

#include <string>
#include <vector>

#include "core/domain/domain.h"

namespace triscope {

/// The points of a list in the file that a curve goes through: first, first + step, … modulo count.
struct CurveSource {
  int first = -1;  // index of the curve's end a; -1: the curve has no points in the file
  int step = 1;    // -1 once the loop has been turned round
  int count = 0;   // length of the list
  int piece = -1;  // index of the piece in a loop made of pieces, else -1
  /// Index in the file of the curve's k-th point.
  [[nodiscard]] int pointAt(int k) const { return first < 0 ? -1 : (((first + k * step) % count) + count) % count; }
};

struct DomainDraft {
  Domain domain;
  std::vector<CurveSource> sources;  // one per curve of the domain
};

}  // namespace triscope
