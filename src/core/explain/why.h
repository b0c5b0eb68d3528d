// Why is this here, why was nothing done about it, and what has happened to it: answers in words, read off the recorded
// events and never computed again. Every element named in them is a link.
//
// Events know a triangle by its id and not its corners, and how many triangles a decision ended but not which. Both are
// facts of the mesh at one moment: core/explain/life.h looks them up, and who has them passes them in.
#pragma once

#include <array>
#include <vector>

#include "core/run/element_events.h"

namespace triscope {

/// What the mesh knows of a triangle and its events do not.
struct TriangleFacts {
  std::array<std::uint32_t, 3> corners{kNoId, kNoId, kNoId};
  std::optional<std::size_t> death;  // event that ended it, when it is known to have ended
};

/// What made the element, and what made that: the rule, with the values it measured and the limits it held them
/// against. A cell's answer leads back to the constraint that asked for its density; a triangle's, with the corners
/// known, tells how it came by its shape.
std::vector<Line> why(Events events, Ref ref, const TriangleFacts& facts = {});

/// Every rule that had a look at the triangle, what it proposed with its figures, and why that was refused; a rule that
/// found nothing to propose, or has not looked yet, is named too.
std::vector<Line> whyNot(Events events, std::uint32_t triangle, const TriangleFacts& facts = {});

/// Birth, moves, flips and death, oldest first; refusals of the same kind in a row are one line. With the corners known
/// the moves that changed the triangle's shape are told too.
std::vector<Line> historyOf(Events events, Ref ref, const TriangleFacts& facts = {});

/// "Event 1204: Step 3 put vertex 611 …"
Line lineOf(Events events, std::size_t index);

}  // namespace triscope
