// Stage "rows", our own: an advancing front of triangles, from the boundary inwards, in place of the paper's two fronts
// and step 1. A triangle is done when it is small enough, or when nothing could be placed for it. A front edge is a
// boundary edge or an edge of a triangle that is done. Triangles beside a front edge wait first in, first out, so that
// the front grows row by row; each gets a point over its shortest front edge. What is left too large in the end gets
// its circumcentre.
//
// The placement "tiling" first puts a hexagonal lattice into the white cells, one for each density rank (the paper,
// section 2, allows some other tiling method), and the rows fill what is between.
#include <algorithm>
#include <cmath>

#include "core/geometry/circumcircle.h"
#include "core/mesh/edit.h"
#include "core/method/stages/limits.h"
#include "core/method/stages/place.h"
#include "core/method/stages/row_placement.h"
#include "core/method/stages/stage_runs.h"
#include "core/method/stages/vertex_sizes.h"

namespace triscope {
namespace {

enum RowPhase : std::uint32_t { tiles, rows, rest };

constexpr double kDone = 1.3;                      // circumradius over that of an equilateral triangle: small enough
constexpr double kLarge = 1.4;                     // … and too large to be left in the end
constexpr double kNearestToRow = 0.7;              // of the edge length, to any other vertex
constexpr double kTileMargin = 1.0;                // around a tile, in its edges, the density rank is the same
constexpr double kRowHeight = 0.8660254037844386;  // of the lattice, in its edges
constexpr std::size_t kFewestPassed = 65536;       // triangles that waited and are forgotten at once

void markDone(MeshState& state, RowsAhead& ahead, Slot slot) {
  if (!ahead.done.has(slot)) ahead.done.resize(std::max(state.mesh.triangles.size(), ahead.done.size() * 3 / 2), {});
  ahead.done[slot] = idOf(state.mesh, slot);
}

void wait(const Mesh& mesh, RowsAhead& ahead, Slot slot) { ahead.waiting.push_back({slot, idOf(mesh, slot)}); }

void waitBesideFront(const Mesh& mesh, RowsAhead& ahead, Slot slot) {
  const RowFront front{mesh, ahead};
  if (front.isDone(slot)) return;
  if (front.has(halfOf(slot, 0)) || front.has(halfOf(slot, 1)) || front.has(halfOf(slot, 2))) wait(mesh, ahead, slot);
}

void waitAround(const Mesh& mesh, RowsAhead& ahead, Slot slot) {
  const RowFront front{mesh, ahead};
  for (const Half across : triangleAt(mesh, slot).adj)
    if (across.exists() && !front.isDone(triangleOf(across))) wait(mesh, ahead, triangleOf(across));
}

void beginRows(MeshState& state, RowsAhead& ahead) {
  const Mesh& mesh = state.mesh;
  state.cursor.index = 0;
  for (const Slot slot : mesh.triangles.keys())
    if (mesh.alive(slot) && isSmall(state, slot, kDone)) markDone(state, ahead, slot);
  for (const Slot slot : mesh.triangles.keys())
    if (mesh.alive(slot)) waitBesideFront(mesh, ahead, slot);
}

void record(const MeshState& state, Journal& journal, Rule rule, TriangleId subject, const RowProposal& proposal,
            const Attempt& attempt) {
  if (!journal.listening()) return;
  Event event = eventIn(state, attempt.vertex.exists() ? EventKind::vertex_inserted : EventKind::vertex_refused, rule);
  event.subject = subject.n;
  event.at = proposal.at;
  describeAttempt(event, attempt);
  if (attempt.vertex.exists()) {
    event.measured = proposal.base;
    event.limit = proposal.size;
  }
  journal.record(event);
}

// Places the point, or says why not. The size in force at the new vertex is that of the proposal.
Outcome decide(MeshState& state, Journal& journal, Rule rule, Slot slot, const RowProposal& proposal) {
  const TriangleId subject = idOf(state.mesh, slot);
  Attempt attempt;
  if (state.mesh.points.size() >= mostVertices(state)) {
    attempt.refusal = Refusal::budget_spent;
  } else if (proposal.misses) {
    attempt.refusal = Refusal::misses_circle;
  } else {
    const double nearest = std::max(kNearestToRow * proposal.size, shortestMade(state));
    attempt = place(state.mesh, state.tree, proposal.at, slot, VertexKind::steiner, {nearest, 0.0}, state.room.placing);
  }
  record(state, journal, rule, rule == Rule::tiling ? TriangleId() : subject, proposal, attempt);
  if (!attempt.vertex.exists()) {
    ++state.counts[state.stage].refused;
    return Outcome::decided;
  }
  state.sizes.resize(state.mesh.points.size());
  state.sizes[attempt.vertex] = proposal.size;
  return Outcome::inserted;
}

Rule ruleOf(Placement placement) {
  switch (placement) {
    case Placement::rebay:
      return Rule::rebay;
    case Placement::size_optimal:
      return Rule::size_optimal;
    default:
      return Rule::spokes;
  }
}

// The next triangle that waits and has something to decide.
Outcome runRow(MeshState& state, Journal& journal, RowsAhead& ahead) {
  Cursor& cursor = state.cursor;
  const Mesh& mesh = state.mesh;
  for (int looked = 0; cursor.index < ahead.waiting.size(); ++looked) {
    if (looked == kPiece) return Outcome::worked;
    const auto [slot, triangle] = ahead.waiting[cursor.index++];
    if (cursor.index > kFewestPassed && 2 * cursor.index > ahead.waiting.size()) {
      ahead.waiting.erase(ahead.waiting.begin(), ahead.waiting.begin() + static_cast<std::ptrdiff_t>(cursor.index));
      cursor.index = 0;
    }
    const RowFront front{mesh, ahead};
    if (!mesh.alive(slot) || idOf(mesh, slot) != triangle || front.isDone(slot)) continue;
    const std::optional<RowProposal> proposal = proposeRow(state, front, slot, state.room.placing.path);
    if (!proposal) continue;
    const Outcome outcome =
        proposal->closes ? Outcome::worked : decide(state, journal, ruleOf(state.settings.placement), slot, *proposal);
    if (outcome != Outcome::inserted) {
      markDone(state, ahead, slot);
      waitAround(mesh, ahead, slot);
      if (proposal->closes) continue;
      return outcome;
    }
    const std::span<const Slot> fan = state.room.placing.cavity.fan();
    for (const Slot made : fan)
      if (isSmall(state, made, kDone)) markDone(state, ahead, made);
    for (const Slot made : fan) {
      if (RowFront{mesh, ahead}.isDone(made))
        waitAround(mesh, ahead, made);
      else
        waitBesideFront(mesh, ahead, made);
    }
    return outcome;
  }
  return Outcome::done;
}

Outcome fillRest(MeshState& state, Journal& journal, RowsAhead& ahead) {
  const Mesh& mesh = state.mesh;
  for (int looked = 0; !ahead.slots.empty(); ++looked) {
    if (looked == kPiece) return Outcome::worked;
    const Slot slot = ahead.slots.back();
    ahead.slots.pop_back();
    if (!mesh.alive(slot) || isSmall(state, slot, kLarge)) continue;
    const Triangle& t = triangleAt(mesh, slot);
    RowProposal proposal;
    proposal.at = circumcentre(pointOf(mesh, t.v[0]), pointOf(mesh, t.v[1]), pointOf(mesh, t.v[2]));
    proposal.base = distance(proposal.at, pointOf(mesh, t.v[0]));
    const double beside = (state.sizes[t.v[0]] + state.sizes[t.v[1]] + state.sizes[t.v[2]]) / 3.0;
    proposal.size = blendedSize(edgeLengthAt(state.tree, proposal.at, state.room.placing.path), beside);
    const Outcome outcome = decide(state, journal, Rule::row_rest, slot, proposal);
    if (outcome == Outcome::inserted)
      for (const Slot made : state.room.placing.cavity.fan()) ahead.slots.push_back(made);
    return outcome;
  }
  return Outcome::done;
}

// Whether a lattice point of a cell's rank has that rank all around it.
bool mayBeTile(MeshState& state, const Cell& cell, Point p, double edge) {
  for (const Point side : {Point{1.0, 0.0}, Point{-1.0, 0.0}, Point{0.0, 1.0}, Point{0.0, -1.0}}) {
    const auto leaf =
        static_cast<std::size_t>(leafAt(state.tree, p + (kTileMargin * edge) * side, state.room.placing.path));
    const Cell& there = state.tree.cells[leaf];
    if (there.density != cell.density || there.type != CellType::white) return false;
  }
  return true;
}

void tileCell(MeshState& state, RowsAhead& ahead, const Cell& cell) {
  const double edge = edgeLengthOf(state.tree, cell.density), height = kRowHeight * edge;
  const Point low = state.tree.corner(cell), origin = state.tree.origin;
  const double side = state.tree.side(cell);
  for (double row = std::ceil((low.y - origin.y) / height); origin.y + row * height < low.y + side; row += 1.0) {
    const double shift = std::fmod(row, 2.0) == 0.0 ? 0.0 : 0.5;
    for (double k = std::ceil((low.x - origin.x) / edge - shift); origin.x + (k + shift) * edge < low.x + side;
         k += 1.0) {
      const Point p{origin.x + (k + shift) * edge, origin.y + row * height};
      if (mayBeTile(state, cell, p, edge)) ahead.tiles.push_back(p);
    }
  }
  std::ranges::reverse(ahead.tiles);
}

// index: cells tiled.
Outcome runTiles(MeshState& state, Journal& journal, RowsAhead& ahead) {
  Cursor& cursor = state.cursor;
  if (state.settings.placement != Placement::tiling) return Outcome::done;
  for (int looked = 0;; ++looked) {
    if (!ahead.tiles.empty()) break;
    if (cursor.index == state.tree.cells.size()) return Outcome::done;
    if (looked == kPiece) return Outcome::worked;
    const Cell cell = state.tree.cells[cursor.index++];
    if (cell.child < 0 && cell.type == CellType::white) tileCell(state, ahead, cell);
  }
  RowProposal proposal;
  proposal.at = ahead.tiles.back();
  ahead.tiles.pop_back();
  proposal.size = proposal.base = edgeLengthAt(state.tree, proposal.at, state.room.placing.path);
  return decide(state, journal, Rule::tiling, state.mesh.lastTriangle, proposal);
}

}  // namespace

Outcome runRows(MeshState& state, Journal& journal) {
  Cursor& cursor = state.cursor;
  RowsAhead& ahead = cursor.of<RowsAhead>();
  if (!cursor.begun) {
    cursor.begun = true;
    extendSizes(state, state.tree.corners);
  }
  if (cursor.phase == RowPhase::tiles) {
    if (const Outcome outcome = runTiles(state, journal, ahead); outcome != Outcome::done) return outcome;
    cursor.phase = RowPhase::rows;
    beginRows(state, ahead);
  }
  if (cursor.phase == RowPhase::rows) {
    if (const Outcome outcome = runRow(state, journal, ahead); outcome != Outcome::done) return outcome;
    cursor.phase = RowPhase::rest;
    for (const Slot slot : state.mesh.triangles.keys())
      if (state.mesh.alive(slot) && !isSmall(state, slot, kLarge)) ahead.slots.push_back(slot);
  }
  return fillRest(state, journal, ahead);
}

}  // namespace triscope
