#include "render/pick.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/density/wanted.h"
#include "core/geometry/predicates.h"
#include "core/mesh/locate.h"

namespace triscope {
namespace {

bool contains(const Mesh& mesh, Slot slot, Point p) {
  const Triangle& t = triangleAt(mesh, slot);
  const Point a = pointOf(mesh, t.v[0]);
  const Point b = pointOf(mesh, t.v[1]);
  const Point c = pointOf(mesh, t.v[2]);
  if (p.x < std::min({a.x, b.x, c.x}) || p.x > std::max({a.x, b.x, c.x}) || p.y < std::min({a.y, b.y, c.y}) ||
      p.y > std::max({a.y, b.y, c.y})) {
    return false;
  }
  return orient2d(a, b, p) >= 0 && orient2d(b, c, p) >= 0 && orient2d(c, a, p) >= 0;
}

double distanceToSegment(Point p, Point a, Point b) {
  const Point along = b - a;
  const double squared = squaredLength(along);
  const double t = squared > 0.0 ? std::clamp(dot(p - a, along) / squared, 0.0, 1.0) : 0.0;
  return distance(p, a + t * along);
}

bool pickVertex(const Mesh& mesh, Point p, double reach, Pick& pick) {
  double best = reach * reach;
  Vertex found;
  for (const Vertex i : mesh.points.keys()) {
    const double d = squaredDistance(mesh.points[i], p);
    if (d > best || (d == best && found.exists())) continue;
    if (mesh.kinds[i] == VertexKind::removed || !mesh.vertexTriangle[i].exists()) continue;
    best = d;
    found = i;
  }
  if (!found.exists()) return false;
  pick = {{Selection::Kind::vertex, found.n, -1}, found.word(), std::sqrt(best)};
  return true;
}

// The nearest edge within reach: of the triangle under p, or of any where p is just outside the mesh.
bool pickEdge(const Mesh& mesh, Point p, double reach, Slot inside, Pick& pick) {
  double best = reach;
  Selection found;
  const auto look = [&](Slot slot) {
    for (int i = 0; i < 3; ++i) {
      const Half half = halfOf(slot, i);
      const double d = distanceToSegment(p, pointOf(mesh, startOf(mesh, half)), pointOf(mesh, endOf(mesh, half)));
      if (d < best) {
        best = d;
        found = {Selection::Kind::edge, slot.n, i};
      }
    }
  };
  if (inside.exists()) {
    look(inside);
  } else {
    for (const Slot slot : mesh.triangles.keys()) {
      if (!mesh.alive(slot)) continue;
      const Triangle& t = mesh.triangles[slot];
      if (t.adj[0].exists() && t.adj[1].exists() && t.adj[2].exists()) continue;  // not at the border
      look(slot);
    }
  }
  if (found.kind == Selection::Kind::none) return false;
  pick = {found, idOf(mesh, found.slot()).n, best};
  return true;
}

bool pickCell(const Quadtree& tree, Point p, Pick& pick) {
  const Cell* const root = cellOf(tree, 0);
  const Point d = p - tree.origin;
  if (root == nullptr || d.x < 0.0 || d.y < 0.0 || d.x > tree.side(*root) || d.y > tree.side(*root)) return false;
  const std::int32_t leaf = wantedAt(tree, p)->cell;
  pick = {{Selection::Kind::cell, leaf, -1}, static_cast<std::uint32_t>(leaf), 0.0};
  return true;
}

}  // namespace

Pick pickOf(const Mesh& mesh, Slot slot) { return {{Selection::Kind::triangle, slot.n, -1}, idOf(mesh, slot).n, 0.0}; }

Pick pickOf(Vertex vertex) { return {{Selection::Kind::vertex, vertex.n, -1}, vertex.word(), 0.0}; }

bool isPartOf(const MeshState& state, const Selection& s) {
  const Mesh& mesh = state.mesh;
  const bool live = mesh.triangles.has(s.slot()) && mesh.alive(s.slot());
  switch (s.kind) {
    case Selection::Kind::none:
      return false;
    case Selection::Kind::vertex:
      return mesh.points.has(s.vertex()) && mesh.kinds[s.vertex()] != VertexKind::removed;
    case Selection::Kind::edge:
      return live && s.edge >= 0 && s.edge < 3;
    case Selection::Kind::triangle:
      return live;
    case Selection::Kind::cell:
      return cellOf(state.tree, s.index) != nullptr;
  }
  return false;
}

Selection present(const MeshState& state, const Pick& pick) {
  Selection s = pick.selection;
  const bool triangle = s.kind == Selection::Kind::triangle || s.kind == Selection::Kind::edge;
  const TriangleId id(pick.id);
  if (triangle && (!isPartOf(state, s) || idOf(state.mesh, s.slot()) != id)) s.index = slotOf(state.mesh, id).n;
  return isPartOf(state, s) ? s : Selection{};
}

Slot triangleContaining(const Mesh& mesh, Point p) {
  if (mesh.liveCount() == 0) return {};
  const Slot last = mesh.lastTriangle;
  if (mesh.triangles.has(last) && mesh.alive(last)) {
    const Location place = walkTo(mesh, last, p);
    if (place.triangle.exists() && !place.blocked.exists() && contains(mesh, place.triangle, p)) return place.triangle;
  }
  for (const Slot slot : mesh.triangles.keys())
    if (mesh.alive(slot) && contains(mesh, slot, p)) return slot;
  return {};
}

Pick pickCellFirst(const MeshState& state, Point p, double reach) {
  Pick cell;
  return pickCell(state.tree, p, cell) ? cell : pick(state, p, reach);
}

Pick pick(const MeshState& state, Point p, double reach) {
  Pick result;
  const Mesh& mesh = state.mesh;
  if (mesh.liveCount() > 0) {
    if (pickVertex(mesh, p, reach, result)) return result;
    const Slot inside = triangleContaining(mesh, p);
    if (pickEdge(mesh, p, reach, inside, result)) return result;
    if (inside.exists()) return pickOf(mesh, inside);
  }
  pickCell(state.tree, p, result);
  return result;
}

}  // namespace triscope
