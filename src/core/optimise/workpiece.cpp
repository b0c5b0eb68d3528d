#include "core/optimise/workpiece.h"

#include "core/mesh/change_log.h"

namespace triscope {

std::size_t verticesAround(Workpiece& work, std::span<const Vertex> seeds, int depth, std::vector<Vertex>& found) {
  Marks<Vertex>& seen = work.room.seen;
  Ring& ring = work.room.ring;
  seen.begin(work.mesh.points.size());
  found.clear();
  for (const Vertex seed : seeds)
    if (seen.take(seed)) found.push_back(seed);
  std::size_t from = 0;
  for (int step = 0; step < depth; ++step) {
    const std::size_t to = found.size();
    for (; from < to; ++from) {
      if (!gatherLinks(work.mesh, found[from], ring)) continue;
      for (const Vertex v : ring.neighbours())
        if (seen.take(v)) found.push_back(v);
    }
  }
  return from;
}

void noteRing(Mesh& mesh, const Ring& ring) {
  if (!mesh.touched) return;
  for (const Half rim : ring.rims()) noteTouched(mesh, triangleOf(rim));
}

void suspectStar(Workpiece& work, Vertex vertex) {
  Ring& ring = work.room.ring;
  if (!gatherLinks(work.mesh, vertex, ring)) return;
  for (const Half rim : ring.rims()) {
    work.room.suspects.push_back(rim);
    work.room.suspects.push_back(halfOf(triangleOf(rim), next3(cornerOf(rim))));
  }
}

}  // namespace triscope
