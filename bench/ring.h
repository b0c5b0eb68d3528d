// The domain that the benchmarks mesh at any size: a graded ring.
#pragma once

#include <memory>

#include "core/domain/domain.h"

namespace triscope::bench {

/// A disc of radius 1 as the hole of a square of side 16. Edges have the length minEdge on the disc and grow away
/// from it, so that most triangles lie near the disc and their number goes like 1 / minEdge.
std::shared_ptr<const Domain> ring(double minEdge);

/// The minEdge that gives about so many vertices after steps 1-5.
double minEdgeFor(double vertices);

}  // namespace triscope::bench
