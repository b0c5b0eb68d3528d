// Room to work in, so that nothing is allocated from one decision to the next. A state has it for itself and nothing in
// it means anything between two decisions: a copy of a state begins with none.
#pragma once

#include <vector>

#include "core/density/quadtree.h"
#include "core/mesh/cavity.h"
#include "core/mesh/edit.h"
#include "core/mesh/flip.h"
#include "core/mesh/move.h"
#include "core/mesh/patch.h"
#include "core/mesh/trial.h"
#include "core/mesh/wheel.h"
#include "core/optimise/workpiece.h"

namespace triscope {

/// To put points in.
struct Placing {
  Cavity cavity;
  LeafPath path;
  Star star;
  std::vector<Half> suspects;
  std::vector<Flip> flips;
};

/// To move vertices and take it back.
struct TrialRoom {
  Wheel wheel;
  MoveLog log;
  std::vector<Slot> before;
};

struct Room {
  Placing placing;
  TrialRoom moves;
  Patch patch;  // what repair tries its edits on
  Trial trial;
  OptimiserRoom optimiser;

  Room() = default;
  Room(const Room&) {}
  Room& operator=(const Room&) { return *this = Room(); }
  Room(Room&&) = default;
  Room& operator=(Room&&) = default;
  ~Room() = default;
};

}  // namespace triscope
