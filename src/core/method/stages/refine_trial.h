// Step 6: whether a move leaves the triangles around it better, and the move itself when it does.
#pragma once

#include "core/mesh/move.h"
#include "core/mesh/wheel.h"
#include "core/method/stages/stage_runs.h"
#include "core/method/state.h"
#include "core/words/event.h"

namespace triscope {

inline constexpr double kLargeAreaRatio = 2.0;  // pairs beyond it get their shared edge moved; no move goes beyond

struct Move {
  Rule rule = Rule::laplacian;
  Vertex vertex;
  Point to;
};

struct Verdict {
  Refusal refusal = Refusal::none;
  double measured = 0.0;  // worst aspect ratio after, and before; or an edge that is too short, and what it may be
  double limit = 0.0;
};

/// Makes the move and flips until the region is Delaunay again, measures the region, and takes everything back when it
/// is worse. What was moved is in `room.log`.
Verdict tryInFull(MeshState& state, const Move& move, TrialRoom& room);

/// The same from one look at the star, where that is enough: no edge wants to be flipped and no bound is broken, before
/// or after, by a margin that rounding cannot bridge. Most trials are such. False, with nothing changed, when it is
/// not sure; else the answer of tryInFull, to the bit.
bool tryInPlace(MeshState& state, const Move& move, const Wheel& wheel, Verdict& verdict);

/// Tries the move, in place or else in full, and records what came of it. `room` holds the star of the vertex, and
/// `subject` is the triangle that the move is for, if any.
Outcome decideMove(MeshState& state, Journal& journal, const Move& move, TriangleId subject, TrialRoom& room);

/// Inner vertices are; those of boundaries stay.
inline bool movable(const Mesh& mesh, Vertex vertex) {
  return !mesh.vertexEdge[vertex].exists() && mesh.vertexTriangle[vertex].exists();
}

}  // namespace triscope
