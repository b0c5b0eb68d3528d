#include "core/mesh/flip.h"

#include "core/base/assert.h"
#include "core/geometry/predicates.h"
#include "core/mesh/change_log.h"
#include "core/mesh/edit.h"

namespace triscope {

std::int32_t flipEdge(Mesh& mesh, std::int32_t half) {
  //      c                 c
  //     /|\               / \          left  = (c, a, b), half a->b opposite c
  //    a-+-b     becomes a---b         right = (d, b, a)
  //     \|/               \ /          (drawn turned: the old diagonal is a-b, the new one c-d)
  //      d                 d
  const std::int32_t other = oppositeOf(mesh, half);
  TRISCOPE_CHECK(other >= 0 && !constrained(mesh, half), "an edge of the boundary is never flipped");
  const std::int32_t left = triangleOf(half);
  const std::int32_t right = triangleOf(other);
  const int i = cornerOf(half);
  const int j = cornerOf(other);
  const std::int32_t a = startOf(mesh, half);
  const std::int32_t b = endOf(mesh, half);
  const std::int32_t c = apexOf(mesh, half);
  const std::int32_t d = apexOf(mesh, other);
  TRISCOPE_CHECK(c != d && startOf(mesh, other) == b, "two triangles share the edge that is flipped");
  const std::int32_t bc = 3 * left + next3(i);   // b -> c
  const std::int32_t ca = 3 * left + prev3(i);   // c -> a
  const std::int32_t ad = 3 * right + next3(j);  // a -> d
  const std::int32_t db = 3 * right + prev3(j);  // d -> b
  const std::int32_t outBc = oppositeOf(mesh, bc), outCa = oppositeOf(mesh, ca);
  const std::int32_t outAd = oppositeOf(mesh, ad), outDb = oppositeOf(mesh, db);
  const bool fixedBc = constrained(mesh, bc), fixedCa = constrained(mesh, ca);
  const bool fixedAd = constrained(mesh, ad), fixedDb = constrained(mesh, db);
  mesh.flags[at(left)] &= static_cast<std::uint8_t>(~(kConstrainedAll | kFillsGap));
  mesh.flags[at(right)] &= static_cast<std::uint8_t>(~(kConstrainedAll | kFillsGap));
  // left = (c, a, d): edge 0 a->d, edge 1 d->c, edge 2 c->a; right = (d, b, c): edge 0 b->c, edge 1 c->d, edge 2 d->b.
  mesh.triangles[at(left)].v = {c, a, d};
  mesh.triangles[at(right)].v = {d, b, c};
  link(mesh, 3 * left, outAd);
  link(mesh, 3 * left + 2, outCa);
  link(mesh, 3 * right, outBc);
  link(mesh, 3 * right + 2, outDb);
  link(mesh, 3 * left + 1, 3 * right + 1);
  if (fixedAd) setConstrained(mesh, 3 * left, true);
  if (fixedCa) setConstrained(mesh, 3 * left + 2, true);
  if (fixedBc) setConstrained(mesh, 3 * right, true);
  if (fixedDb) setConstrained(mesh, 3 * right + 2, true);
  for (const std::int32_t out : {outAd, outCa, outBc, outDb}) {
    if (out >= 0) mesh.tested[at(triangleOf(out))] = 0;
  }
  noteTouched(mesh, left);
  noteTouched(mesh, right);
  mesh.tested[at(left)] = 0;
  mesh.tested[at(right)] = 0;
  mesh.ids[at(left)] = mesh.nextId++;
  mesh.ids[at(right)] = mesh.nextId++;
  mesh.vertexTriangle[at(a)] = left;
  mesh.vertexTriangle[at(b)] = right;
  mesh.vertexTriangle[at(c)] = left;
  mesh.vertexTriangle[at(d)] = right;
  return 3 * left + 1;
}

bool flipWanted(const Mesh& mesh, std::int32_t half) {
  const std::int32_t other = oppositeOf(mesh, half);
  if (other < 0 || constrained(mesh, half)) return false;
  const Triangle& t = triangleAt(mesh, triangleOf(half));
  return incircle(pointOf(mesh, t.v[0]), pointOf(mesh, t.v[1]), pointOf(mesh, t.v[2]),
                  pointOf(mesh, apexOf(mesh, other))) > 0;
}

void restoreDelaunay(Mesh& mesh, std::vector<std::int32_t>& suspects, std::vector<Flip>& done, std::size_t most) {
  const std::size_t before = done.size();
  while (!suspects.empty() && done.size() - before < most) {
    const std::int32_t half = suspects.back();
    suspects.pop_back();
    if (!flipWanted(mesh, half)) continue;
    const std::int32_t other = oppositeOf(mesh, half);
    done.push_back({startOf(mesh, half), endOf(mesh, half), apexOf(mesh, half), apexOf(mesh, other)});
    const std::int32_t diagonal = flipEdge(mesh, half);
    const std::int32_t left = triangleOf(diagonal);
    const std::int32_t right = triangleOf(oppositeOf(mesh, diagonal));
    for (const std::int32_t slot : {left, right}) {
      for (int i = 0; i < 3; ++i) {
        if (3 * slot + i != diagonal && 3 * slot + i != oppositeOf(mesh, diagonal)) suspects.push_back(3 * slot + i);
      }
    }
  }
}

}  // namespace triscope
