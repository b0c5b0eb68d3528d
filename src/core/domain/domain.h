// The domain to mesh: closed loops and open chains of curves, what the user asks of the density, and the
// smallest edge. A Domain that left readDomain() or checkDomain() is simple, disjoint and oriented.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/point.h"
#include "core/domain/curve.h"

namespace triscope {

enum class LoopRole : std::uint8_t { outer, hole, chain };

/// A run of curves, end to end. The domain lies to the left: outer counter-clockwise, holes clockwise.
struct Loop {
  std::string name;  // as in the file, or "outer", "hole 1", "segment 1"
  LoopRole role = LoopRole::outer;
  std::uint32_t firstCurve = 0;  // index into Domain::curves
  std::uint32_t curveCount = 0;
};

/// An edge length (or rank) that the user asks for somewhere.
struct DensityRequest {
  enum class Where : std::uint8_t { point, loop, box } where = Where::point;
  Point at = {};          // point; lower corner of the box
  Point to = {};          // upper corner of the box
  std::string loop = {};  // name of the loop
  int rank = 0;           // density rank >= 1, or 0 when a length is given
  double length = 0.0;    // edge length > 0, or 0 when a rank is given
  std::string name = {};  // label shown to the user, may be empty
  std::string description = {};
  friend bool operator==(const DensityRequest&, const DensityRequest&) = default;
};

struct Domain {
  std::string name;
  std::string file;            // where it was read from, empty when made in memory
  std::string text;            // the domain file itself, empty when made in memory
  double minEdgeLength = 0.0;  // the paper's Δx; 0: derive it from the geometry
  std::vector<Loop> loops;     // loops[0] is the outer one
  std::vector<Curve> curves;   // of one loop after the other, in their order
  std::vector<DensityRequest> density;
  Box bounds;
};

}  // namespace triscope
