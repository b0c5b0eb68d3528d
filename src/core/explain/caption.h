// What an event means, in plain English: what happened, and why.
#pragma once

#include <string>

#include "core/method/state.h"
#include "core/quality/quality.h"
#include "core/words/event.h"

namespace triscope {

/// "Step 3 put vertex 611 at the circumcentre of triangle 5790: its circumradius R = 2.31 is not below …"
/// One or two sentences, UTF-8, with the event's own figures; nothing is computed again.
std::string captionOf(const Event& event);

/// What a stage has come to, with its count: "Density is done: 88 cells, ranks 1–6, 1807 triangles estimated."
/// `finished` is the event stage_finished that led to `state`.
std::string captionOf(const Event& finished, const MeshState& state);

/// Where the run as a whole is: before its first decision, between two, failed, or finished with these figures.
std::string summaryOf(const MeshState& state, const Quality& quality);

}  // namespace triscope
