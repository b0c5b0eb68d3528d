#include "core/mesh/split_edge.h"

#include "core/base/assert.h"
#include "core/mesh/change_log.h"
#include "core/mesh/edit.h"

namespace triscope {
namespace {

void setConstrained(Mesh& mesh, Slot slot, bool edge0, bool edge1, bool edge2) {
  mesh.flags[slot] = static_cast<std::uint8_t>(edge0 | edge1 << 1 | edge2 << 2);
}

// The triangle of one side, c over a -> b, becomes (c, a, middle) in its slot and (c, middle, b) in another one. Their
// halves of the edge are edge 1 and 2 the other way round: half-edges 0 of both. Returns the other slot.
Slot splitSide(Mesh& mesh, Half half, Vertex middle, EditLog& log) {
  const Slot slot = triangleOf(half);
  const int corner = cornerOf(half);
  const Vertex a = startOf(mesh, half), b = endOf(mesh, half), c = apexOf(mesh, half);
  const Half bc = halfOf(slot, next3(corner)), ca = halfOf(slot, prev3(corner));
  const Half outBc = oppositeOf(mesh, bc), outCa = oppositeOf(mesh, ca);
  const bool fixed = constrained(mesh, half), fixedBc = constrained(mesh, bc), fixedCa = constrained(mesh, ca);
  const Slot other = addTriangle(mesh, c, middle, b, log);
  save(mesh, slot, log);
  mesh.triangles[slot] = {{c, a, middle}, {}};
  mesh.ids[slot] = mesh.nextId++;
  mesh.tested[slot] = 0;
  setConstrained(mesh, slot, fixed, false, fixedCa);
  setConstrained(mesh, other, fixed, fixedBc, false);
  link(mesh, halfOf(slot, 2), outCa, log);
  link(mesh, halfOf(other, 1), outBc, log);
  link(mesh, halfOf(slot, 1), halfOf(other, 2), log);
  noteTouched(mesh, slot);
  mesh.vertexTriangle[a] = slot;
  mesh.vertexTriangle[c] = slot;
  mesh.vertexTriangle[middle] = slot;
  return other;
}

// The corners of the triangles on either side: which triangle they name may change.
void saveCorners(const Mesh& mesh, Half half, EditLog& log) {
  for (const Half side : {half, oppositeOf(mesh, half)})
    if (side.exists())
      for (const Vertex v : triangleAt(mesh, triangleOf(side)).v) save(mesh, v, log);
}

// Both sides of an edge that has two.
void splitSides(Mesh& mesh, Half half, Vertex middle, EditLog& log) {
  const Half across = oppositeOf(mesh, half);
  const Slot left = triangleOf(half), right = triangleOf(across);
  const Slot leftEnd = splitSide(mesh, half, middle, log);     // (c, middle, b)
  const Slot rightEnd = splitSide(mesh, across, middle, log);  // (d, middle, a)
  link(mesh, halfOf(left, 0), halfOf(rightEnd, 0), log);       // a - middle
  link(mesh, halfOf(leftEnd, 0), halfOf(right, 0), log);       // middle - b
}

}  // namespace

Vertex splitInnerEdge(Mesh& mesh, Half half, Point at, std::uint8_t density, EditLog& log) {
  TRISCOPE_CHECK(oppositeOf(mesh, half).exists() && !constrained(mesh, half), "an inner edge has two sides");
  saveCorners(mesh, half, log);
  const Vertex middle = addVertex(mesh, at, VertexKind::steiner, density);
  splitSides(mesh, half, middle, log);
  return middle;
}

Vertex splitBorderEdge(Mesh& mesh, Half half, EdgeId edge, double t, Point at, std::uint8_t density, EditLog& log) {
  TRISCOPE_CHECK(constrained(mesh, half), "an edge of the boundary is split so");
  saveCorners(mesh, half, log);
  // Whoever names the edge in the list of its second end is written to.
  const Vertex last = mesh.edges[edge].v1;
  for (EdgeId e = mesh.vertexEdge[last]; e.exists(); e = nextEdgeAt(mesh, e, last)) save(mesh, e, log);
  save(mesh, edge, log);
  const Vertex middle = addVertex(mesh, at, VertexKind::split, density);
  splitBoundaryEdge(mesh, edge, middle, t);
  if (oppositeOf(mesh, half).exists())
    splitSides(mesh, half, middle, log);
  else
    splitSide(mesh, half, middle, log);
  return middle;
}

}  // namespace triscope
