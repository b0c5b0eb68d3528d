// One function per stage: makes the next decision of the stage, or says that the stage is done.
#pragma once

#include "core/method/pipeline.h"

namespace triscope {

Outcome runConstraints(MeshState& state, Journal& journal);
Outcome runQuadtree(MeshState& state, Journal& journal);
Outcome runDensity(MeshState& state, Journal& journal);
Outcome runBoundary(MeshState& state, Journal& journal);
Outcome runTriangulation(MeshState& state, Journal& journal);
Outcome runRecovery(MeshState& state, Journal& journal);
Outcome runCarve(MeshState& state, Journal& journal);
Outcome runFront1(MeshState& state, Journal& journal);
Outcome runFront2(MeshState& state, Journal& journal);
Outcome runRows(MeshState& state, Journal& journal);
Outcome runSteps(MeshState& state, Journal& journal);  // step 1 … 5, by state.stage
Outcome runRepair(MeshState& state, Journal& journal);
Outcome runRefine(MeshState& state, Journal& journal);
Outcome runOptimise(MeshState& state, Journal& journal);
/// Passes that it has, counted by MeshState::round from 1; some may be left out.
int optimiserPasses();

/// Cells that a stage looks at before it says `worked`: some microseconds.
inline constexpr int kPiece = 1024;

/// An event that carries the stage and round of the state.
inline Event eventIn(const MeshState& state, EventKind kind, Rule rule) {
  Event event;
  event.kind = kind;
  event.stage = state.stage;
  event.round = state.round;
  event.rule = rule;
  return event;
}

}  // namespace triscope
