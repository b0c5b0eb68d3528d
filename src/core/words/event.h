// One event for each decision: the rule, the subject, the measured value and the limit it was held against,
// what it made, or why it was refused. "Why is this here?" is answered from these, never computed again.
// What `subject`, `other` and `created` are ids of, and how a kind, a rule and a refusal are put into words, stands in
// vocabulary.h.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/point.h"
#include "core/words/stage.h"

namespace triscope {

enum class EventKind : std::uint8_t {
  stage_begun,       // subject: round
  constraint_found,  // measured: length asked for; limit: 0
  cell_split,        // created: first of its four children
  cell_ranked,       // measured: new density rank; limit: rank before
  boundary_point,    // other: index in MeshState::boundary; measured: edge length h there
  vertex_inserted,   // subject: triangle id it was proposed for (kNoId when none); vertex: the new one
  vertex_refused,    // at: where it would have gone; refusal: why
  edge_split,        // vertex: the new one, on the boundary; subject: index in Mesh::edges
  vertex_removed,    // vertex: gone
  triangle_removed,
  vertex_moved,    // vertex; from, where the last event that placed it says -> at
  vertex_kept,     // vertex; from: where it stays; at: where it would have gone; refusal: why
  stage_finished,  // subject: decisions made in it that changed something
  failure,         // the method cannot go on; at: where
  edit_kept,       // subject: triangle id that it was for; vertex: that it was for; at: where; the events before it in
                   // the same decision say which vertices it moved, made or removed
  edit_undone,     // the same, but nothing is changed; refusal: why
};
inline constexpr int kEventKindCount = static_cast<int>(EventKind::edit_undone) + 1;

enum class Rule : std::uint8_t {
  none,
  user_request,
  curvature,
  corner,
  gap,
  short_edge,  // sources of density (section 2)
  balance,
  advancing_front,  // quadtree
  boundary_point,
  initial,
  recover_edge,
  carve,  // boundary and initial triangulation (section 3)
  first_front,
  second_front,
  step1,
  step2,
  step3,
  step4,
  step5,   // section 3.1
  repair,  // our own: clears what a refusal left behind
  laplacian,
  reduce_obtuse,
  shared_edge,  // section 4
  polish,       // our own: what is worst in the mesh
  rebay,
  size_optimal,
  spokes,
  tiling,
  row_rest,  // placements in rows
  smooth,
  best_shape,
  delaunay_flip,
  anneal,
  relax,
  cure_relax,
  cure_flip,
  cure_collapse,
  cure_split,
  cure_pair,  // the optimiser, our own
};
inline constexpr int kRuleCount = static_cast<int>(Rule::cure_pair) + 1;

enum class Refusal : std::uint8_t {
  none,
  outside_domain,       // the point is not in the domain
  too_close,            // closer to a vertex than allowed: measured < limit
  encroaches_boundary,  // it sees a boundary edge under too wide an angle
  edge_below_minimum,   // an edge would be shorter than Δx
  inverts_triangle,     // a triangle would turn over
  star_worse,           // the star would be worse than before
  bound_broken,         // a bound of section 3 would no longer hold
  budget_spent,
  too_many_triangles,  // the mesh would have more than Settings::maxTriangles
  misses_circle,       // the point lies outside the circumcircle of the triangle that it was proposed for
  too_thin,            // a triangle would become too thin
  patch_worse,         // the patch around an edit would not be better
};
inline constexpr int kRefusalCount = static_cast<int>(Refusal::patch_worse) + 1;

inline constexpr std::uint32_t kNoId = 0xffffffffu;

struct Event {
  EventKind kind = EventKind::stage_begun;
  Stage stage = Stage::constraints;
  Rule rule = Rule::none;
  Refusal refusal = Refusal::none;
  std::uint16_t round = 0;         // of steps 2-5, or pass of a stage that refines
  std::uint16_t removedCount = 0;  // triangles that the decision destroyed
  std::uint32_t subject = kNoId;
  std::uint32_t other = kNoId;
  std::uint32_t vertex = kNoId;
  std::uint32_t created = kNoId;   // first triangle id (or cell) that the decision made
  std::uint32_t createdCount = 0;  // ids created, created + 1, …
  double measured = 0.0;
  double limit = 0.0;
  Point at;
  Point from;
};

/// Where events go. A run without a listener makes none: guard with `if (journal.listening())`.
struct Journal {
  std::vector<Event>* events = nullptr;
  [[nodiscard]] bool listening() const { return events != nullptr; }
  void record(const Event& event) { events->push_back(event); }
};

}  // namespace triscope
