// Annealing of degrees: dislocations of the mesh, a vertex of five triangles beside one of seven, glide along it by
// flips until they meet another and both are gone.
#pragma once

#include "core/optimise/workpiece.h"

namespace triscope {

/// Per vertex, how many triangles it has beyond six, on a border beyond the number of sixths of a turn that its angle
/// is nearest to, two of a right angle. -100 to 100. O(n).
Excess excessOf(const Mesh& mesh);
int excessOf(const Mesh& mesh, Vertex vertex);

enum class GlideOutcome : std::uint8_t {
  none,    // no flips lead to a smaller sum of squared excesses
  kept,    // they were made, and the patch around them smoothed and made Delaunay
  undone,  // they were, but with them a triangle would be thin, or the sum would not stay smaller
};

struct Glide {
  GlideOutcome outcome = GlideOutcome::none;
  int sumBefore = 0;  // of squared excesses in the patch
  int sumAfter = 0;
  int searched = 0;  // flips tried on the way
};

/// Looks from a vertex for a sequence of at most three flips, none of which raises the sum of squared excesses and the
/// last of which lowers it, by the links alone; carries it out, smooths the two rings around it with the new links, and
/// makes them Delaunay. What is kept is saved in the log; the patch is in `room.patch`.
Glide glideFrom(Workpiece& work, Excess& excess, Vertex vertex);

}  // namespace triscope
