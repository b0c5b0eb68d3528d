#include "core/mesh/edit.h"

#include "core/base/assert.h"
#include "core/mesh/change_log.h"

namespace triscope {

std::int32_t addVertex(Mesh& mesh, Point p, VertexKind kind, std::uint8_t density) {
  mesh.points.push_back(p);
  mesh.kinds.push_back(kind);
  mesh.density.push_back(density);
  mesh.vertexTriangle.push_back(-1);
  mesh.vertexEdge.push_back(-1);
  return static_cast<std::int32_t>(mesh.points.size()) - 1;
}

std::int32_t takeSlot(Mesh& mesh) {
  if (mesh.freeSlots.empty()) {
    TRISCOPE_CHECK(mesh.triangles.size() < kMostSlots, "half-edges are numbered in 32 bits");
    mesh.triangles.emplace_back();
    mesh.ids.push_back(0);
    mesh.flags.push_back(kDead);
    mesh.tested.push_back(0);
    return static_cast<std::int32_t>(mesh.triangles.size()) - 1;
  }
  const std::int32_t slot = mesh.freeSlots.back();
  mesh.freeSlots.pop_back();
  TRISCOPE_CHECK(!mesh.alive(slot), "a free slot holds no triangle");
  return slot;
}

std::int32_t addTriangle(Mesh& mesh, std::int32_t a, std::int32_t b, std::int32_t c) {
  TRISCOPE_CHECK(a != b && b != c && c != a, "a triangle has three corners");
  const std::int32_t slot = takeSlot(mesh);
  mesh.flags[at(slot)] = 0;
  mesh.tested[at(slot)] = 0;
  mesh.triangles[at(slot)] = {{a, b, c}, {-1, -1, -1}};
  mesh.ids[at(slot)] = mesh.nextId++;
  noteTouched(mesh, slot);
  mesh.vertexTriangle[at(a)] = slot;
  mesh.vertexTriangle[at(b)] = slot;
  mesh.vertexTriangle[at(c)] = slot;
  return slot;
}

void killTriangle(Mesh& mesh, std::int32_t slot) {
  TRISCOPE_CHECK(mesh.alive(slot), "a triangle is removed once");
  mesh.flags[at(slot)] = kDead;
  mesh.tested[at(slot)] = kTestedAll;
  mesh.freeSlots.push_back(slot);
  noteTouched(mesh, slot);
}

namespace {

int cornerWith(const Triangle& triangle, std::int32_t vertex) {
  return triangle.v[0] == vertex ? 0 : triangle.v[1] == vertex ? 1 : 2;
}

}  // namespace

void starOf(const Mesh& mesh, std::int32_t vertex, Star& star) {
  star.rim.clear();
  star.closed = false;
  const std::int32_t first = mesh.vertexTriangle[at(vertex)];
  if (first < 0) return;
  // Turn clockwise to the boundary, or all the way round, then collect counter-clockwise.
  std::int32_t slot = first;
  for (;;) {
    const Triangle& triangle = triangleAt(mesh, slot);
    const std::int32_t across = triangle.adj[static_cast<std::size_t>(prev3(cornerWith(triangle, vertex)))];
    if (across < 0) break;
    slot = triangleOf(across);
    if (slot == first) break;
  }
  const std::int32_t start = slot;
  for (;;) {
    const Triangle& triangle = triangleAt(mesh, slot);
    const int corner = cornerWith(triangle, vertex);
    star.rim.push_back(3 * slot + corner);
    const std::int32_t across = triangle.adj[static_cast<std::size_t>(next3(corner))];
    if (across < 0) return;
    slot = triangleOf(across);
    if (slot == start) break;
  }
  star.closed = true;
}

std::int32_t findHalfEdge(const Mesh& mesh, std::int32_t a, std::int32_t b) {
  const std::int32_t first = mesh.vertexTriangle[at(a)];
  if (first < 0) return -1;
  for (int direction = 0; direction < 2; ++direction) {
    std::int32_t slot = first;
    do {
      const Triangle& triangle = triangleAt(mesh, slot);
      const int corner = cornerWith(triangle, a);
      if (triangle.v[static_cast<std::size_t>(next3(corner))] == b) return 3 * slot + prev3(corner);
      const int side = direction == 0 ? next3(corner) : prev3(corner);
      const std::int32_t across = triangle.adj[static_cast<std::size_t>(side)];
      if (across < 0) break;
      slot = triangleOf(across);
    } while (slot != first);
  }
  return -1;
}

std::int32_t addBoundaryEdge(Mesh& mesh, const BoundaryEdge& edge) {
  TRISCOPE_CHECK(edge.v0 != edge.v1, "a boundary edge has two ends");
  const auto index = static_cast<std::int32_t>(mesh.edges.size());
  mesh.edges.push_back(edge);
  mesh.edges.back().next0 = mesh.vertexEdge[at(edge.v0)];
  mesh.vertexEdge[at(edge.v0)] = index;
  mesh.edges.back().next1 = mesh.vertexEdge[at(edge.v1)];
  mesh.vertexEdge[at(edge.v1)] = index;
  return index;
}

std::int32_t findBoundaryEdge(const Mesh& mesh, std::int32_t a, std::int32_t b) {
  for (std::int32_t e = mesh.vertexEdge[at(a)]; e >= 0;) {
    const BoundaryEdge& edge = mesh.edges[at(e)];
    if ((edge.v0 == a && edge.v1 == b) || (edge.v0 == b && edge.v1 == a)) return e;
    e = edge.v0 == a ? edge.next0 : edge.next1;
  }
  return -1;
}

std::int32_t splitBoundaryEdge(Mesh& mesh, std::int32_t e, std::int32_t middle, double t) {
  const BoundaryEdge old = mesh.edges[at(e)];
  const auto rest = static_cast<std::int32_t>(mesh.edges.size());
  // In the list of v1 the new edge takes the old one's place.
  std::int32_t* link = &mesh.vertexEdge[at(old.v1)];
  while (*link != e) {
    TRISCOPE_CHECK(*link >= 0, "a boundary edge is in the lists of both its ends");
    BoundaryEdge& step = mesh.edges[at(*link)];
    link = step.v0 == old.v1 ? &step.next0 : &step.next1;
  }
  *link = rest;
  mesh.edges[at(e)] = {old.v0, middle, old.curve, old.next0, rest, old.t0, t};
  mesh.edges.push_back({middle, old.v1, old.curve, -1, old.next1, t, old.t1});
  mesh.vertexEdge[at(middle)] = e;
  return rest;
}

}  // namespace triscope
