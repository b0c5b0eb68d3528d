// Leading vertices back to where nothing around them is beyond the aims.
#pragma once

#include "core/optimise/penalty.h"
#include "core/optimise/workpiece.h"

namespace triscope {

/// Whether what a move leaves is made Delaunay at once.
enum class Flipping : std::uint8_t { never, where_obtuse };

struct RelaxStep {
  bool moved = false;
  Point to;             // where it was put, or would have been put first
  double before = 0.0;  // penalty of the star
  double after = 0.0;
};

/// One Gauss-Newton step of a vertex on the penalty of its star, shortened until the penalty falls; along the curve for
/// a vertex that slides on the boundary, and none for one that is fixed. What is written to is saved in the log.
RelaxStep relaxVertex(Workpiece& work, Vertex vertex, const PenaltyLimits& limits, Flipping flipping);

/// Relaxes the vertices, those near what moves again, until nothing moves or helps much, with `visits` steps at most.
void relaxPatch(Workpiece& work, std::span<const Vertex> vertices, const PenaltyLimits& limits, Flipping flipping,
                int visits);

}  // namespace triscope
