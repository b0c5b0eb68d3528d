#include "core/mesh/flip.h"

#include "core/base/assert.h"
#include "core/geometry/predicates.h"
#include "core/mesh/change_log.h"
#include "core/mesh/edit.h"

namespace triscope {

Half flipEdge(Mesh& mesh, Half half) {
  //      c                 c
  //     /|\               / \          left  = (c, a, b), half a->b opposite c
  //    a-+-b     becomes a---b         right = (d, b, a)
  //     \|/               \ /          (drawn turned: the old diagonal is a-b, the new one c-d)
  //      d                 d
  const Half other = oppositeOf(mesh, half);
  TRISCOPE_CHECK(other.exists() && !constrained(mesh, half), "an edge of the boundary is never flipped");
  const Slot left = triangleOf(half);
  const Slot right = triangleOf(other);
  const int i = cornerOf(half);
  const int j = cornerOf(other);
  const Vertex a = startOf(mesh, half);
  const Vertex b = endOf(mesh, half);
  const Vertex c = apexOf(mesh, half);
  const Vertex d = apexOf(mesh, other);
  TRISCOPE_CHECK(c != d && startOf(mesh, other) == b, "two triangles share the edge that is flipped");
  const Half bc = halfOf(left, next3(i));   // b -> c
  const Half ca = halfOf(left, prev3(i));   // c -> a
  const Half ad = halfOf(right, next3(j));  // a -> d
  const Half db = halfOf(right, prev3(j));  // d -> b
  const Half outBc = oppositeOf(mesh, bc), outCa = oppositeOf(mesh, ca);
  const Half outAd = oppositeOf(mesh, ad), outDb = oppositeOf(mesh, db);
  const bool fixedBc = constrained(mesh, bc), fixedCa = constrained(mesh, ca);
  const bool fixedAd = constrained(mesh, ad), fixedDb = constrained(mesh, db);
  mesh.flags[left] &= static_cast<std::uint8_t>(~(kConstrainedAll | kFillsGap));
  mesh.flags[right] &= static_cast<std::uint8_t>(~(kConstrainedAll | kFillsGap));
  // left = (c, a, d): edge 0 a->d, edge 1 d->c, edge 2 c->a; right = (d, b, c): edge 0 b->c, edge 1 c->d, edge 2 d->b.
  mesh.triangles[left].v = {c, a, d};
  mesh.triangles[right].v = {d, b, c};
  link(mesh, halfOf(left, 0), outAd);
  link(mesh, halfOf(left, 2), outCa);
  link(mesh, halfOf(right, 0), outBc);
  link(mesh, halfOf(right, 2), outDb);
  link(mesh, halfOf(left, 1), halfOf(right, 1));
  if (fixedAd) constrain(mesh, halfOf(left, 0));
  if (fixedCa) constrain(mesh, halfOf(left, 2));
  if (fixedBc) constrain(mesh, halfOf(right, 0));
  if (fixedDb) constrain(mesh, halfOf(right, 2));
  for (const Half out : {outAd, outCa, outBc, outDb}) {
    if (out.exists()) mesh.tested[triangleOf(out)] = 0;
  }
  noteTouched(mesh, left);
  noteTouched(mesh, right);
  mesh.tested[left] = 0;
  mesh.tested[right] = 0;
  mesh.ids[left] = mesh.nextId++;
  mesh.ids[right] = mesh.nextId++;
  mesh.vertexTriangle[a] = left;
  mesh.vertexTriangle[b] = right;
  mesh.vertexTriangle[c] = left;
  mesh.vertexTriangle[d] = right;
  return halfOf(left, 1);
}

bool flipWanted(const Mesh& mesh, Half half) {
  const Half other = oppositeOf(mesh, half);
  if (!other.exists() || constrained(mesh, half)) return false;
  const Triangle& t = triangleAt(mesh, triangleOf(half));
  return incircle(pointOf(mesh, t.v[0]), pointOf(mesh, t.v[1]), pointOf(mesh, t.v[2]),
                  pointOf(mesh, apexOf(mesh, other))) > 0;
}

void restoreDelaunay(Mesh& mesh, std::vector<Half>& suspects, std::vector<Flip>& done, std::size_t most) {
  const std::size_t before = done.size();
  while (!suspects.empty() && done.size() - before < most) {
    const Half half = suspects.back();
    suspects.pop_back();
    if (!flipWanted(mesh, half)) continue;
    const Half other = oppositeOf(mesh, half);
    done.push_back({startOf(mesh, half), endOf(mesh, half), apexOf(mesh, half), apexOf(mesh, other)});
    const Half diagonal = flipEdge(mesh, half);
    const Slot left = triangleOf(diagonal);
    const Slot right = triangleOf(oppositeOf(mesh, diagonal));
    for (const Slot slot : {left, right}) {
      for (int i = 0; i < 3; ++i) {
        if (halfOf(slot, i) != diagonal && halfOf(slot, i) != oppositeOf(mesh, diagonal))
          suspects.push_back(halfOf(slot, i));
      }
    }
  }
}

}  // namespace triscope
