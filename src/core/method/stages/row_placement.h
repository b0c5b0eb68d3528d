// Where the next point of an advancing front goes.
#pragma once

#include <optional>

#include "core/method/state.h"

namespace triscope {

/// A view of the front: edges of the boundary, and of triangles that are done.
struct RowFront {
  const Mesh& mesh;
  const RowsAhead& ahead;

  [[nodiscard]] bool isDone(Slot slot) const { return ahead.done.has(slot) && ahead.done[slot] == idOf(mesh, slot); }
  [[nodiscard]] bool has(Half half) const {
    const Half across = oppositeOf(mesh, half);
    return !across.exists() || constrained(mesh, half) || isDone(triangleOf(across));
  }
};

/// A triangle is small when its circumradius is at most `factor` times that of an equilateral one of the size in force.
bool isSmall(const MeshState& state, Slot slot, double factor);

struct RowProposal {
  Point at;
  double size = 0.0;    // edge length in force there
  double base = 0.0;    // length of the front edge that it stands over
  bool closes = false;  // nothing is placed: what is there already fills the angle at an end of that edge
  bool misses = false;  // the point lies outside the triangle's circumcircle, or too low over its edge
};
/// Over the shortest front edge of a triangle; nothing when it has none.
std::optional<RowProposal> proposeRow(const MeshState& state, const RowFront& front, Slot slot, LeafPath& path);

/// The edge length in force at a new point: the mean of what is asked for there and what is in force beside it, and not
/// more beyond the latter than a row may grow by.
double blendedSize(double asked, double beside);

}  // namespace triscope
