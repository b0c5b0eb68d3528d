// Putting a point into the triangulation, or saying why not: shared by the stages that insert.
#pragma once

#include "core/mesh/cavity.h"
#include "core/mesh/locate.h"
#include "core/method/state.h"
#include "core/words/event.h"

namespace triscope {

/// What one attempt to insert a point is held to.
struct Demand {
  double nearest = 0.0;  // no vertex may be nearer than this
  double sightCosine =
      -1.0;  // a boundary edge may not be seen under an angle with a smaller cosine (0: 90°, -0.5: 120°)
};

struct Attempt {
  Refusal refusal = Refusal::none;
  double measured = 0.0;  // what the refusal measured, and the limit it was held against
  double limit = 0.0;
  Half wall;           // half-edge of the boundary edge that is in the way, if any
  Vertex vertex;       // the new vertex when nothing refused it
  TriangleId firstId;  // of the new triangles
  std::uint32_t createdCount = 0;
  std::uint32_t removedCount = 0;
};

/// Walks from `start` to p, finds the cavity, holds p to the demand, and inserts it when it passes. Leaves the cavity,
/// with the new triangles as its fan, in `placing`.
Attempt place(Mesh& mesh, const Quadtree& tree, Point p, Slot start, VertexKind kind, const Demand& demand,
              Placing& placing);

/// Splits boundary edge `edge` (index in Mesh::edges) at half its parameter, on the true curve. Refused when a half
/// would be shorter than minEdge, or the new point does not see the triangles around it.
Attempt splitBoundary(Mesh& mesh, const Domain& domain, const Quadtree& tree, EdgeId edge, double minEdge,
                      Placing& placing);

/// Fills in what an attempt did: vertex or refusal, measured and limit, created and removed.
void describeAttempt(Event& event, const Attempt& attempt);

}  // namespace triscope
