#include "core/mesh/locate.h"

#include "core/geometry/predicates.h"
#include "core/mesh/edit.h"

namespace triscope {

namespace {

// The walk is the innermost loop of every insertion: telling of each triangle costs nothing where nobody listens.
template <class Visit>
Location walk(const Mesh& mesh, std::int32_t start, Point p, Visit visit) {
  std::int32_t slot = start;
  int from = -1;
  visit(slot);
  // A constrained triangulation may lead the walk in a circle; then the straight walk decides.
  for (std::size_t budget = 2 * mesh.triangles.size() + 8; budget > 0; --budget) {
    const Triangle& triangle = triangleAt(mesh, slot);
    int exit = -1;
    int wall = -1;
    for (int i = 0; i < 3; ++i) {
      if (i == from) continue;
      const Point a = pointOf(mesh, triangle.v[static_cast<std::size_t>(next3(i))]);
      const Point b = pointOf(mesh, triangle.v[static_cast<std::size_t>(prev3(i))]);
      if (orient2d(a, b, p) >= 0) continue;
      if (constrained(mesh, 3 * slot + i) || triangle.adj[static_cast<std::size_t>(i)] < 0) {
        wall = i;
        continue;
      }
      exit = i;
      break;
    }
    if (exit < 0) return {slot, wall < 0 ? -1 : 3 * slot + wall};
    const std::int32_t across = triangle.adj[static_cast<std::size_t>(exit)];
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

Location walkTo(const Mesh& mesh, std::int32_t start, Point p, std::vector<std::int32_t>* passed) {
  if (passed == nullptr) return walk(mesh, start, p, [](std::int32_t) {});
  return walk(mesh, start, p, [passed](std::int32_t slot) { passed->push_back(slot); });
}

Location walkStraight(const Mesh& mesh, std::int32_t start, Point from, Point p) {
  std::int32_t slot = start;
  int entered = -1;
  for (std::size_t budget = mesh.triangles.size() + 8; budget > 0; --budget) {
    const Triangle& triangle = triangleAt(mesh, slot);
    int exit = -1;
    if (entered < 0) {
      // Leave the first triangle through the edge whose ends lie on both sides of the line (the left one may be on it).
      for (int i = 0; i < 3 && exit < 0; ++i) {
        const Point a = pointOf(mesh, triangle.v[static_cast<std::size_t>(next3(i))]);
        const Point b = pointOf(mesh, triangle.v[static_cast<std::size_t>(prev3(i))]);
        if (orient2d(from, p, a) < 0 && orient2d(from, p, b) >= 0) exit = i;
      }
    } else {
      // The edge entered through runs from its left end, corner next3, to its right end; the apex decides which of the
      // two is left behind.
      const bool apexLeft = orient2d(from, p, pointOf(mesh, triangle.v[static_cast<std::size_t>(entered)])) >= 0;
      exit = apexLeft ? next3(entered) : prev3(entered);
    }
    if (exit < 0) return {slot, -1};
    const Point a = pointOf(mesh, triangle.v[static_cast<std::size_t>(next3(exit))]);
    const Point b = pointOf(mesh, triangle.v[static_cast<std::size_t>(prev3(exit))]);
    if (orient2d(a, b, p) >= 0) return {slot, -1};
    const std::int32_t half = 3 * slot + exit;
    const std::int32_t across = triangle.adj[static_cast<std::size_t>(exit)];
    if (across < 0 || constrained(mesh, half)) return {slot, half};
    slot = triangleOf(across);
    entered = cornerOf(across);
  }
  return {slot, -1};
}

}  // namespace triscope
