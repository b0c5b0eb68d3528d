// The measures of a mesh in parts, so that after a few changes only few of them are measured again.
#pragma once

#include <cstdint>
#include <vector>

#include "core/quality/quality.h"

namespace triscope {

/// The worst value seen and where; equal values go to the lowest id, whatever the order of the slots.
struct WorstSeen {
  double value = 0.0;
  TriangleId id;
  Slot slot;
  Slot other;
};

/// A running sum that keeps what each addition rounds away.
struct RunningSum {
  double total = 0.0;
  double lost = 0.0;
};

/// What a stretch of slots comes to. A pair of triangles belongs to the lower slot of the two.
struct QualityPart {
  std::size_t triangles = 0;
  std::size_t obtuse = 0;
  WorstSeen aspect, areaRatio, edgeRatio, minAngle, maxAngle, minEdge;
  RunningSum area, aspects;
};

/// measure(mesh), and what it was put together from.
struct QualityInParts {
  Quality quality;
  std::vector<QualityPart> parts;
};

QualityInParts measureInParts(const Mesh& mesh);
/// The same, to the last bit, of a mesh that differs from one measured before.
QualityInParts measureInParts(const Mesh& mesh, const Mesh& before, QualityInParts measured);

}  // namespace triscope
