// The parts of the optimiser that look at one vertex or edge at a time. Each function makes the next decision of its
// pass; `done` when the pass is over.
#pragma once

#include "core/method/stages/stage_runs.h"
#include "core/optimise/glide.h"
#include "core/optimise/workpiece.h"

namespace triscope {

struct Optimiser {
  MeshState& state;
  Optimising& ahead;
  Journal& journal;
  Workpiece work;
};

Outcome runSmooth(Optimiser& o);
Outcome runShape(Optimiser& o);
/// Edges that are not Delaunay after a pass of moves.
Outcome runFlips(Optimiser& o);
Outcome runAnneal(Optimiser& o);
void beginRelax(Optimiser& o);
Outcome runRelax(Optimiser& o);

/// What is told of an edit, or of a run of flips.
struct EditReport {
  Rule rule = Rule::none;
  Refusal refusal = Refusal::none;
  TriangleId subject{};  // triangle that it is for
  Vertex vertex{};       // or vertex
  Point at{};
  double measured = 0.0;
  double limit = 0.0;
};
/// Counts an edit that is kept, and records what the log says it did: vertices put in, taken out and moved, and then
/// the edit itself. `before` is the mesh's mark when it began.
Outcome decideKept(Optimiser& o, const EditReport& report, const EditMark& before);
/// The same for one that was undone.
Outcome decideUndone(Optimiser& o, const EditReport& report);

}  // namespace triscope
