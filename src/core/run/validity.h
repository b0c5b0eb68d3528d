// The rules that a run may never break, checked as it goes: on what a decision changed, and as a whole at the end of a
// stage. What they find is asked for by conditions ("delaunay_broken") and by the search for the first violation.
#pragma once

#include <cstdint>
#include <span>

#include "core/method/state.h"
#include "core/words/event.h"

namespace triscope {

enum Validity : std::uint8_t {
  kOrientation = 1,    // a triangle that changed is not counter-clockwise
  kDelaunay = 2,       // an edge of a triangle that changed is not locally Delaunay
  kMinimumLength = 4,  // an edge of a triangle that changed is shorter than the smallest length
  kBoundary = 8,       // a boundary edge beside a triangle that changed is no edge of the mesh
  kBalance = 16,       // neighbouring leaves of the quadtree differ by more than a cell rank
  kArea = 32,          // the triangles do not fill what the boundary encloses
};

/// The shortest straight piece of the input, which edges may be as short as.
double shortestInput(const MeshState& state);

/// Bits of the rules broken after a decision that changed these slots and made these events. Balance and area are
/// looked at where a stage ends.
std::uint8_t brokenRules(const MeshState& state, std::span<const Slot> changed, std::span<const Event> events,
                         double shortestInput);

}  // namespace triscope
