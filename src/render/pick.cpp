#include "render/pick.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/density/wanted.h"
#include "core/geometry/predicates.h"
#include "core/mesh/locate.h"

namespace triscope {
namespace {

using std::size_t;

bool contains(const Mesh& mesh, std::int32_t slot, Point p) {
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
  std::int32_t found = -1;
  for (size_t i = 0; i < mesh.points.size(); ++i) {
    const double d = squaredDistance(mesh.points[i], p);
    if (d > best || (d == best && found >= 0)) continue;
    if (mesh.kinds[i] == VertexKind::removed || mesh.vertexTriangle[i] < 0) continue;
    best = d;
    found = static_cast<std::int32_t>(i);
  }
  if (found < 0) return false;
  pick = {{Selection::Kind::vertex, found, -1}, static_cast<std::uint32_t>(found), std::sqrt(best)};
  return true;
}

// The nearest edge within reach: of the triangle under p, or of any where p is just outside the mesh.
bool pickEdge(const Mesh& mesh, Point p, double reach, std::int32_t inside, Pick& pick) {
  double best = reach;
  Selection found;
  const auto look = [&](std::int32_t slot) {
    for (int i = 0; i < 3; ++i) {
      const std::int32_t half = 3 * slot + i;
      const double d = distanceToSegment(p, pointOf(mesh, startOf(mesh, half)), pointOf(mesh, endOf(mesh, half)));
      if (d < best) {
        best = d;
        found = {Selection::Kind::edge, slot, i};
      }
    }
  };
  if (inside >= 0) {
    look(inside);
  } else {
    for (size_t i = 0; i < mesh.triangles.size(); ++i) {
      const auto slot = static_cast<std::int32_t>(i);
      if (!mesh.alive(slot)) continue;
      const Triangle& t = mesh.triangles[i];
      if (t.adj[0] >= 0 && t.adj[1] >= 0 && t.adj[2] >= 0) continue;  // not at the border
      look(slot);
    }
  }
  if (found.kind == Selection::Kind::none) return false;
  pick = {found, idOf(mesh, found.index), best};
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

bool isPartOf(const MeshState& state, const Selection& s) {
  const Mesh& mesh = state.mesh;
  const auto index = static_cast<size_t>(s.index);  // beyond every end where it is negative
  const bool live = index < mesh.triangles.size() && mesh.alive(s.index);
  switch (s.kind) {
    case Selection::Kind::none:
      return false;
    case Selection::Kind::vertex:
      return index < mesh.points.size() && mesh.kinds[index] != VertexKind::removed;
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
  if (triangle && (!isPartOf(state, s) || idOf(state.mesh, s.index) != pick.id)) s.index = slotOf(state.mesh, pick.id);
  return isPartOf(state, s) ? s : Selection{};
}

std::int32_t triangleContaining(const Mesh& mesh, Point p) {
  if (mesh.liveCount() == 0) return -1;
  const std::int32_t last = mesh.lastTriangle;
  if (last >= 0 && static_cast<size_t>(last) < mesh.triangles.size() && mesh.alive(last)) {
    const Location place = walkTo(mesh, last, p);
    if (place.triangle >= 0 && place.blocked < 0 && contains(mesh, place.triangle, p)) return place.triangle;
  }
  for (size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto slot = static_cast<std::int32_t>(i);
    if (mesh.alive(slot) && contains(mesh, slot, p)) return slot;
  }
  return -1;
}

Pick pick(const MeshState& state, Point p, double reach, bool cellsFirst) {
  Pick result;
  if (cellsFirst && pickCell(state.tree, p, result)) return result;
  const Mesh& mesh = state.mesh;
  if (mesh.liveCount() > 0) {
    if (pickVertex(mesh, p, reach, result)) return result;
    const std::int32_t inside = triangleContaining(mesh, p);
    if (pickEdge(mesh, p, reach, inside, result)) return result;
    if (inside >= 0) return {{Selection::Kind::triangle, inside, -1}, idOf(mesh, inside), 0.0};
  }
  pickCell(state.tree, p, result);
  return result;
}

}  // namespace triscope
