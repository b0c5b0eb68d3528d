#include "core/quality/input_angle.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/trig.h"
#include "core/mesh/edit.h"

namespace triscope {
namespace {

constexpr double kPromised = 60.0 - 1e-9;  // degrees: 60° itself, measured with an error, is no small angle

double angleAt(const Mesh& mesh, Slot slot, int corner) {
  const auto& v = triangleAt(mesh, slot).v;
  const Point apex = pointOf(mesh, v[corner]);
  return std::fabs(trig::angleBetween(pointOf(mesh, v[next3(corner)]) - apex, pointOf(mesh, v[prev3(corner)]) - apex)) /
         trig::kDegree;
}

/// Sum of the angles at a vertex from the triangle's neighbour on one side to the next boundary edge.
double angleBeyond(const Mesh& mesh, Slot slot, int corner, bool forward) {
  const Vertex vertex = triangleAt(mesh, slot).v[corner];
  double sum = 0.0;
  while (sum < kPromised) {
    const Half half = halfOf(slot, forward ? next3(corner) : prev3(corner));
    const Half across = oppositeOf(mesh, half);
    if (!across.exists() || constrained(mesh, half)) return sum;
    slot = triangleOf(across);
    const auto& v = triangleAt(mesh, slot).v;
    corner = static_cast<int>(std::find(v.begin(), v.end(), vertex) - v.begin());
    sum += angleAt(mesh, slot, corner);
  }
  return sum;
}

}  // namespace

std::optional<InputAngle> smallInputAngle(const Mesh& mesh, Slot slot) {
  std::optional<InputAngle> smallest;
  for (int corner = 0; corner < 3; ++corner) {
    const double angle =
        angleAt(mesh, slot, corner) + angleBeyond(mesh, slot, corner, true) + angleBeyond(mesh, slot, corner, false);
    if (angle >= kPromised || (smallest && angle >= smallest->degrees)) continue;
    smallest = InputAngle{pointOf(mesh, triangleAt(mesh, slot).v[corner]), angle};
  }
  return smallest;
}

}  // namespace triscope
