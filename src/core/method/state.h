// The kernel is a value: a copy of MeshState is a snapshot that can be carried on, and gives the same bytes as
// a run that was never stopped. No pointer into itself, no thread, no callback; domain and method are shared and const.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/each.h"
#include "core/density/constraint.h"
#include "core/density/constraint_search.h"
#include "core/density/quadtree.h"
#include "core/domain/domain.h"
#include "core/mesh/mesh.h"
#include "core/method/cursor.h"
#include "core/method/method.h"
#include "core/method/room.h"
#include "core/words/settings.h"
#include "core/words/stage.h"

namespace triscope {

struct StageCounts {
  std::uint64_t decisions = 0;
  std::uint64_t inserted = 0;
  std::uint64_t refused = 0;
  std::uint64_t moved = 0;
  std::uint64_t removed = 0;
};

/// A boundary point before it is a vertex.
struct BoundaryPoint {
  Point at;
  std::uint32_t curve = 0;
  double t = 0.0;
  bool kept = false;  // a corner or input point
  Vertex vertex;
};

struct MeshState {
  std::shared_ptr<const Domain> domain;
  const Method* method = &paperMethod();
  Settings settings;
  double minEdge = 0.0;  // Δx in force
  bool minEdgeDerived = false;
  ConstraintSearch search;  // while constraints are looked for
  std::vector<Constraint> constraints;
  Quadtree tree;
  double estimatedTriangles = 0.0;  // Table 1, known after the density stage
  std::vector<BoundaryPoint> boundary;
  Mesh mesh;
  Per<Vertex, double> sizes;   // edge length in force at each vertex, while rows are placed or the mesh is optimised
  std::vector<Vertex> front1;  // vertices, in the order placed
  std::vector<Vertex> front2;
  std::vector<Vertex> frontLoops;    // the first front as closed loops, each ended by none
  Stage stage = Stage::constraints;  // the stage that the next decision belongs to
  std::uint16_t round = 0;           // of steps 2-5, from 1; pass of a stage that refines
  std::uint64_t roundChanges = 0;    // insertions since this round began
  std::uint16_t roundsDone = 0;      // rounds of steps 2-5 begun and left behind, and …
  std::uint16_t passesDone = 0;      // … passes of the refinement; they stay when `round` begins again
  Cursor cursor;
  std::uint64_t tick = 0;       // decisions made
  std::uint64_t heavyWork = 0;  // what some of them took longer than others do, in decisions: see workOf()
  Each<Stage, StageCounts, kStageCount> counts{};
  bool failed = false;  // the method could not go on; the state stays to be looked at
  Room room;
};

/// What it took to come here, in decisions of the usual kind (some half a microsecond): how far apart keyframes are
/// best.
inline std::uint64_t workOf(const MeshState& state) { return state.tick + state.heavyWork; }

/// No edge is meant to be shorter: Δx, or half of it once the mesh is held to the lengths that are wanted by ratio,
/// which rows of points, continuous lengths and the optimiser do.
double shortestMeant(const MeshState& state);

/// 64-bit digest of everything above except the domain, the method, the counts, the work and the room.
std::uint64_t hashOf(const MeshState& state);

}  // namespace triscope
