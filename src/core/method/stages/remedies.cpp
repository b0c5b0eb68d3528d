#include "core/method/stages/remedies.h"

#include <algorithm>

#include "core/geometry/circumcircle.h"
#include "core/geometry/trig.h"
#include "core/mesh/badness.h"
#include "core/mesh/edit.h"
#include "core/mesh/move.h"
#include "core/mesh/remove.h"

namespace triscope {
namespace {

// A vertex with more triangles than this around it is not taken out, and of a hub with more boundary edges only those
// to other vertices at hand are split: what is tried around one triangle stays a few hundred edits.
constexpr std::size_t kLargestStar = 64;
constexpr int kLargestHub = 8;

void addMoves(const Mesh& patch, Vertex vertex, std::vector<Remedy>& remedies) {
  Star star;
  starOf(patch, vertex, star);
  if (!star.closed || patch.vertexEdge[vertex].exists()) return;
  const Point p = pointOf(patch, vertex);
  Point mean;
  double reach = 0.0;
  for (const Half rim : star.rim) {
    const Point q = pointOf(patch, startOf(patch, rim));
    mean = mean + q;
    reach += distance(p, q);
  }
  const double n = static_cast<double>(star.rim.size());
  reach /= n;
  remedies.push_back({MeshEdit::move, (1.0 / n) * mean, vertex, {}});
  for (const double radius : {0.06, 0.15, 0.3}) {
    for (int k = 0; k < 8; ++k) {
      const trig::SinCos turn = trig::sinCos(k * 45.0 * trig::kDegree);
      remedies.push_back({MeshEdit::move, p + (radius * reach) * Point{turn.cos, turn.sin}, vertex, {}});
    }
  }
}

void addInsertions(const Mesh& patch, Slot slot, std::vector<Remedy>& remedies) {
  const Triangle& t = triangleAt(patch, slot);
  const Point a = pointOf(patch, t.v[0]), b = pointOf(patch, t.v[1]), c = pointOf(patch, t.v[2]);
  const Point middle = centroidOf(patch, slot);
  const Point centre = circumcentre(a, b, c);
  remedies.push_back({MeshEdit::insert, middle, {}, {}});
  for (const double part : {0.5, 0.75, 1.0})
    remedies.push_back({MeshEdit::insert, middle + part * (centre - middle), {}, {}});
  for (int i = 0; i < 3; ++i) {
    const Point m =
        midpoint(pointOf(patch, startOf(patch, halfOf(slot, i))), pointOf(patch, endOf(patch, halfOf(slot, i))));
    if (oppositeOf(patch, halfOf(slot, i)).exists()) remedies.push_back({MeshEdit::insert, m, {}, {}});
  }
}

Slot patient(const Mesh& patch) {
  for (const Slot slot : patch.triangles.keys())
    if (patch.alive(slot) && breaksBound(patch, slot)) return slot;
  return firstLive(patch);
}

void addRemoval(const Mesh& patch, Vertex vertex, std::vector<Remedy>& remedies) {
  Star star;
  starOf(patch, vertex, star);
  if (star.rim.size() <= kLargestStar) remedies.push_back({MeshEdit::remove, pointOf(patch, vertex), vertex, {}});
}

void addSplits(const Mesh& patch, Vertex vertex, const std::vector<Vertex>& near, std::vector<Remedy>& remedies) {
  const auto eachEdge = [&](const auto& visit) {
    for (EdgeId e = patch.vertexEdge[vertex]; e.exists();) {
      const BoundaryEdge& edge = patch.edges[e];
      visit(e, edge, edge.v0 == vertex ? edge.v1 : edge.v0);
      e = edge.v0 == vertex ? edge.next0 : edge.next1;
    }
  };
  int edges = 0;
  eachEdge([&](EdgeId, const BoundaryEdge&, Vertex) { ++edges; });
  eachEdge([&](EdgeId e, const BoundaryEdge& edge, Vertex other) {
    if (edges > kLargestHub && std::find(near.begin(), near.end(), other) == near.end()) return;
    remedies.push_back({MeshEdit::split, midpoint(pointOf(patch, edge.v0), pointOf(patch, edge.v1)), {}, e});
  });
}

}  // namespace

Slot firstLive(const Mesh& mesh) {
  Slot slot(0);
  while (!mesh.alive(slot)) ++slot;
  return slot;
}

void collectRemedies(const Mesh& patch, std::vector<Remedy>& remedies) {
  remedies.clear();
  std::vector<Vertex> near;
  std::vector<Slot> slots;
  const Slot centre = patient(patch);
  near.assign(triangleAt(patch, centre).v.begin(), triangleAt(patch, centre).v.end());
  slots.assign(1, centre);
  for (std::size_t k = 0; k < slots.size(); ++k) {
    for (const Half across : triangleAt(patch, slots[k]).adj) {
      if (!across.exists()) continue;
      if (std::find(near.begin(), near.end(), apexOf(patch, across)) == near.end())
        near.push_back(apexOf(patch, across));
      if (k == 0) slots.push_back(triangleOf(across));
    }
  }
  for (const Vertex vertex : near) addMoves(patch, vertex, remedies);
  for (const Slot slot : slots) addInsertions(patch, slot, remedies);
  for (const Vertex vertex : near) {
    if (!patch.vertexEdge[vertex].exists()) {
      addRemoval(patch, vertex, remedies);
    } else {
      addSplits(patch, vertex, near, remedies);
    }
  }
}

Attempt applyRemedy(Mesh& mesh, const MeshState& state, const Remedy& remedy, Slot start, double floor, Room& room) {
  Attempt attempt;
  attempt.refusal = Refusal::inverts_triangle;
  switch (remedy.edit) {
    case MeshEdit::move:
      attempt.firstId = mesh.nextId;
      if (moveVertex(mesh, remedy.vertex, remedy.to, room.moves.log)) attempt.refusal = Refusal::none;
      attempt.createdCount = mesh.nextId.n - attempt.firstId.n;
      return attempt;
    case MeshEdit::insert:
      return place(mesh, state.tree, remedy.to, start, VertexKind::steiner, {floor, -0.5}, room.placing);
    case MeshEdit::remove:
      attempt.firstId = mesh.nextId;
      if (removeVertex(mesh, remedy.vertex)) attempt.refusal = Refusal::none;
      attempt.createdCount = mesh.nextId.n - attempt.firstId.n;
      return attempt;
    case MeshEdit::split:
      return splitBoundary(mesh, *state.domain, state.tree, remedy.edge, floor, room.placing);
    case MeshEdit::none:
      break;
  }
  return attempt;
}

}  // namespace triscope
