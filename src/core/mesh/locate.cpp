#include "core/mesh/locate.h"

#include "core/geometry/predicates.h"
#include "core/mesh/edit.h"

namespace triscope {

namespace {

// The walk is the innermost loop of every insertion: telling of each triangle costs nothing where nobody listens.
template <class Visit>
Location walk(const Mesh& mesh, Slot start, Point p, Visit visit) {
  Slot slot = start;
  int from = -1;
  visit(slot);
  // A constrained triangulation may lead the walk in a circle; then the straight walk decides.
  for (std::size_t budget = 2 * mesh.triangles.size() + 8; budget > 0; --budget) {
    const Triangle& triangle = triangleAt(mesh, slot);
    int exit = -1;
    int wall = -1;
    for (int i = 0; i < 3; ++i) {
      if (i == from) continue;
      const Point a = pointOf(mesh, triangle.v[next3(i)]);
      const Point b = pointOf(mesh, triangle.v[prev3(i)]);
      if (orient2d(a, b, p) >= 0) continue;
      if (constrained(mesh, halfOf(slot, i)) || !triangle.adj[i].exists()) {
        wall = i;
        continue;
      }
      exit = i;
      break;
    }
    if (exit < 0) return {slot, wall < 0 ? Half() : halfOf(slot, wall)};
    const Half across = triangle.adj[exit];
    slot = triangleOf(across);
    from = cornerOf(across);
    visit(slot);
  }
  const Triangle& triangle = triangleAt(mesh, start);
  const Point a = pointOf(mesh, triangle.v[0]);
  const Point b = pointOf(mesh, triangle.v[1]);
  const Point c = pointOf(mesh, triangle.v[2]);
  const Location location = walkStraight(mesh, start, {(a.x + b.x + c.x) / 3.0, (a.y + b.y + c.y) / 3.0}, p);
  visit(location.triangle);
  return location;
}

}  // namespace

Location walkTo(const Mesh& mesh, Slot start, Point p, std::vector<Slot>* passed) {
  if (passed == nullptr) return walk(mesh, start, p, [](Slot) {});
  return walk(mesh, start, p, [passed](Slot slot) { passed->push_back(slot); });
}

Location walkStraight(const Mesh& mesh, Slot start, Point from, Point p) {
  Slot slot = start;
  int entered = -1;
  for (std::size_t budget = mesh.triangles.size() + 8; budget > 0; --budget) {
    const Triangle& triangle = triangleAt(mesh, slot);
    int exit = -1;
    if (entered < 0) {
      // Leave the first triangle through the edge whose ends lie on both sides of the line (the left one may be on it).
      for (int i = 0; i < 3 && exit < 0; ++i) {
        const Point a = pointOf(mesh, triangle.v[next3(i)]);
        const Point b = pointOf(mesh, triangle.v[prev3(i)]);
        if (orient2d(from, p, a) < 0 && orient2d(from, p, b) >= 0) exit = i;
      }
    } else {
      // The edge entered through runs from its left end, corner next3, to its right end; the apex decides which of the
      // two is left behind.
      const bool apexLeft = orient2d(from, p, pointOf(mesh, triangle.v[entered])) >= 0;
      exit = apexLeft ? next3(entered) : prev3(entered);
    }
    if (exit < 0) return {slot, {}};
    const Point a = pointOf(mesh, triangle.v[next3(exit)]);
    const Point b = pointOf(mesh, triangle.v[prev3(exit)]);
    if (orient2d(a, b, p) >= 0) return {slot, {}};
    const Half half = halfOf(slot, exit);
    const Half across = triangle.adj[exit];
    if (!across.exists() || constrained(mesh, half)) return {slot, half};
    slot = triangleOf(across);
    entered = cornerOf(across);
  }
  return {slot, {}};
}

}  // namespace triscope
