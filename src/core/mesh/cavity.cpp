#include "core/mesh/cavity.h"

#include "core/geometry/predicates.h"
#include "core/mesh/edit.h"

namespace triscope {
namespace {

bool inCircle(const Mesh& mesh, std::int32_t slot, Point p) {
  const Triangle& t = triangleAt(mesh, slot);
  return incircle(pointOf(mesh, t.v[0]), pointOf(mesh, t.v[1]), pointOf(mesh, t.v[2]), p) > 0;
}

// Depth first, edges counter-clockwise, so that the rim comes out in order around p.
void grow(Mesh& mesh, Point p, Cavity& cavity, std::vector<std::int32_t>& stack) {
  while (!stack.empty()) {
    const std::int32_t half = stack.back();
    stack.pop_back();
    const std::int32_t across = oppositeOf(mesh, half);
    const bool wall = across < 0 || constrained(mesh, half);
    const std::int32_t slot = wall ? -1 : triangleOf(across);
    if (slot < 0 || (mesh.flags[at(slot)] & kInCavity) != 0 || !inCircle(mesh, slot, p)) {
      cavity.rim.push_back(half);
      continue;
    }
    mesh.flags[at(slot)] |= kInCavity;
    cavity.triangles.push_back(slot);
    const int entered = cornerOf(across);
    stack.push_back(3 * slot + prev3(entered));
    stack.push_back(3 * slot + next3(entered));
  }
}

void unmark(Mesh& mesh, const Cavity& cavity) {
  for (const std::int32_t slot : cavity.triangles) mesh.flags[at(slot)] &= static_cast<std::uint8_t>(~kInCavity);
}

// The edge on the stack when a triangle is entered twice would be an inner edge of the cavity: cannot happen for a
// cavity that is a disc, which exact in-circle tests guarantee.
thread_local std::vector<std::int32_t> stackOfHalves;

}  // namespace

void findCavity(Mesh& mesh, Point p, std::int32_t start, Cavity& cavity) {
  cavity.triangles.assign(1, start);
  cavity.rim.clear();
  mesh.flags[at(start)] |= kInCavity;
  stackOfHalves.assign({3 * start + 2, 3 * start + 1, 3 * start});
  grow(mesh, p, cavity, stackOfHalves);
  unmark(mesh, cavity);
}

bool findSplitCavity(Mesh& mesh, Point p, std::int32_t edge, Cavity& cavity) {
  cavity.triangles.clear();
  cavity.rim.clear();
  const std::int32_t other = oppositeOf(mesh, edge);
  for (const std::int32_t side : {edge, other}) {
    if (side < 0) continue;
    const std::int32_t slot = triangleOf(side);
    mesh.flags[at(slot)] |= kInCavity;
    cavity.triangles.push_back(slot);
    stackOfHalves.assign({3 * slot + prev3(cornerOf(side)), 3 * slot + next3(cornerOf(side))});
    grow(mesh, p, cavity, stackOfHalves);
  }
  unmark(mesh, cavity);
  for (const std::int32_t half : cavity.rim) {
    if (orient2d(pointOf(mesh, startOf(mesh, half)), pointOf(mesh, endOf(mesh, half)), p) <= 0) {
      cavity.triangles.clear();
      cavity.rim.clear();
      return false;
    }
  }
  return true;
}

namespace {

thread_local std::vector<std::int32_t> rimStart;
thread_local std::vector<std::int32_t> rimEnd;
thread_local std::vector<std::int32_t> rimAcross;
thread_local std::vector<std::uint8_t> rimConstrained;

// Copies the rim out of the cavity's triangles, frees them, and hangs a fan around a new vertex. Neighbours along
// the fan are joined where one rim edge ends at the start of the next. Returns the new vertex; the fan's slots
// replace rimStart.
std::int32_t fan(Mesh& mesh, const Cavity& cavity, Point p, VertexKind kind, std::uint8_t density) {
  const std::size_t n = cavity.rim.size();
  rimStart.resize(n);
  rimEnd.resize(n);
  rimAcross.resize(n);
  rimConstrained.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    const std::int32_t half = cavity.rim[k];
    rimStart[k] = startOf(mesh, half);
    rimEnd[k] = endOf(mesh, half);
    rimAcross[k] = oppositeOf(mesh, half);
    rimConstrained[k] = constrained(mesh, half) ? 1 : 0;
  }
  for (const std::int32_t slot : cavity.triangles) killTriangle(mesh, slot);
  const std::int32_t vertex = addVertex(mesh, p, kind, density);
  std::int32_t before = -1;
  std::int32_t first = -1;
  for (std::size_t k = 0; k < n; ++k) {
    const std::int32_t slot = addTriangle(mesh, vertex, rimStart[k], rimEnd[k]);
    link(mesh, 3 * slot, rimAcross[k]);
    if (rimAcross[k] >= 0) mesh.tested[at(triangleOf(rimAcross[k]))] = 0;
    if (rimConstrained[k] != 0) setConstrained(mesh, 3 * slot, true);
    if (before >= 0 && rimEnd[k - 1] == rimStart[k]) link(mesh, 3 * slot + 2, 3 * before + 1);
    if (first < 0) first = slot;
    before = slot;
  }
  if (n > 0 && rimEnd[n - 1] == rimStart[0]) link(mesh, 3 * first + 2, 3 * before + 1);
  mesh.lastTriangle = before;
  return vertex;
}

}  // namespace

std::int32_t fillCavity(Mesh& mesh, const Cavity& cavity, Point p, VertexKind kind, std::uint8_t density) {
  return fan(mesh, cavity, p, kind, density);
}

std::int32_t fillSplitCavity(Mesh& mesh, const Cavity& cavity, Point p, std::int32_t edge, double t,
                             std::uint8_t density) {
  const std::int32_t vertex = fan(mesh, cavity, p, VertexKind::split, density);
  const std::int32_t rest = splitBoundaryEdge(mesh, edge, vertex, t);
  for (const std::int32_t e : {edge, rest}) {
    const std::int32_t a = mesh.edges[at(e)].v0;
    const std::int32_t b = mesh.edges[at(e)].v1;
    for (const std::int32_t half : {findHalfEdge(mesh, a, b), findHalfEdge(mesh, b, a)}) {
      if (half >= 0) setConstrained(mesh, half, true);
    }
  }
  return vertex;
}

double nearestSquaredDistance(const Mesh& mesh, const Cavity& cavity, Point p) {
  double nearest = 1e300;
  for (const std::int32_t half : cavity.rim) {
    const double d = squaredDistance(pointOf(mesh, startOf(mesh, half)), p);
    if (d < nearest) nearest = d;
  }
  return nearest;
}

}  // namespace triscope
