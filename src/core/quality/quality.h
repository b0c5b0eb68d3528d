// Measures of one triangle and of a pair (paper, section 1.1), and the worst of a mesh.
#pragma once

#include <cstdint>

#include "core/mesh/mesh.h"

namespace triscope {

struct TriangleQuality {
  double circumradius = 0.0;
  double inradius = 0.0;
  double aspect = 0.0;     // R/r, 2 for the equilateral triangle
  double edgeRatio = 0.0;  // longest / shortest edge
  double shortest = 0.0;
  double longest = 0.0;
  double area = 0.0;      // signed
  double minAngle = 0.0;  // degrees
  double maxAngle = 0.0;  // degrees
  bool obtuse = false;    // by the exact sign of a dot product, not by the angle
};

/// Of a triangle in any orientation. Without area the aspect is infinite; with two equal corners the edge ratio too.
TriangleQuality qualityOf(Point a, Point b, Point c);
TriangleQuality qualityOf(const Mesh& mesh, Slot slot);

/// The bounds of section 3: every value must lie strictly inside.
struct Bounds {
  static constexpr double aspect = 4.31;
  static constexpr double areaRatio = 3.0;
  static constexpr double edgeRatio = 2.0;
  static constexpr double minAngle = 30.0;
  static constexpr double maxAngle = 120.0;
};

/// Worst values over all live triangles but those at a corner of the box around everything; the slot is the triangle
/// that has it, none for an empty mesh. Ties go to the lowest id. Area ratio is over pairs that share an edge: the
/// larger of the two is named first; where no two do, it is 1.
struct Quality {
  std::size_t vertices = 0;          // that some triangle uses
  std::size_t boundaryVertices = 0;  // of these, ends of a boundary edge (inner chains count)
  std::size_t triangles = 0;
  std::size_t obtuse = 0;
  double aspectMax = 0.0;
  Slot aspectAt;
  double areaRatioMax = 0.0;
  Slot areaRatioAt;
  Slot areaRatioOther;
  double edgeRatioMax = 0.0;
  Slot edgeRatioAt;
  double minAngle = 180.0;  // degrees
  Slot minAngleAt;
  double maxAngle = 0.0;
  Slot maxAngleAt;
  double minEdge = 0.0;
  Slot minEdgeAt;
  double area = 0.0;
  double aspectMean = 0.0;

  [[nodiscard]] bool withinBounds() const {
    return aspectMax < Bounds::aspect && areaRatioMax < Bounds::areaRatio && edgeRatioMax < Bounds::edgeRatio &&
           minAngle > Bounds::minAngle && maxAngle < Bounds::maxAngle;
  }
};

Quality measure(const Mesh& mesh);

}  // namespace triscope
