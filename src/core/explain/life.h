// What events do not say of an element and the mesh does at the right moment: found by replay from the nearest
// keyframe, so that a run pays nothing for it.
#pragma once

#include "core/explain/why.h"
#include "core/run/history.h"

namespace triscope {

/// Corners of a live triangle; nothing when the mesh has no such triangle.
std::optional<TriangleFacts> factsOf(const Mesh& mesh, TriangleId triangle);

/// Corners of a triangle made by event `birth`, and the event that ended it before decision `end`, the number of
/// decisions of the run so far. Looks through the keyframes for the last that has it (copies nothing), then replays to
/// its death or to the next keyframe: costs about as much as one seek. One that lived and died between two keyframes is
/// found by replaying those.
TriangleFacts factsOf(const History& history, std::uint64_t end, Events events, TriangleId triangle);

}  // namespace triscope
