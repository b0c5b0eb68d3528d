#include "core/mesh/collapse_edge.h"

#include <algorithm>

#include "core/base/assert.h"
#include "core/mesh/change_log.h"
#include "core/mesh/edit.h"
#include "core/mesh/slide.h"

namespace triscope {
namespace {

bool onRim(const Mesh& mesh, const Star& star, Vertex vertex) {
  return std::ranges::any_of(star.rim,
                             [&](Half rim) { return startOf(mesh, rim) == vertex || endOf(mesh, rim) == vertex; });
}

// Vertices that both ends of the edge have an edge to: where there are others than the apexes over the edge, two
// triangles would come to lie between the same vertices.
int commonNeighbours(const Mesh& mesh, const Star& gone, const Star& stays, Vertex end) {
  int common = 0;
  for (const Half rim : gone.rim)
    if (startOf(mesh, rim) != end && onRim(mesh, stays, startOf(mesh, rim))) ++common;
  if (gone.closed) return common;
  const Vertex last = endOf(mesh, gone.rim.back());
  return common + (last != end && onRim(mesh, stays, last) ? 1 : 0);
}

// The edge from `gone` to the apex of a triangle beside the collapsed edge, whose edge from `stays` to it is `rim`.
Half besideGone(const Mesh& mesh, Half rim, Vertex stays) {
  const int corner = cornerOf(rim);
  return halfOf(triangleOf(rim), startOf(mesh, rim) == stays ? next3(corner) : prev3(corner));
}

// The edge from `gone` to where the rim of one of its triangles begins.
Half spokeTo(Half rim) { return halfOf(triangleOf(rim), prev3(cornerOf(rim))); }

// The triangle beside the collapsed edge vanishes: its other two edges become one. `rim` is the one that stays.
void closeTriangle(Mesh& mesh, Half rim, Vertex stays, EditLog& log) {
  const Vertex apex = startOf(mesh, rim) == stays ? endOf(mesh, rim) : startOf(mesh, rim);
  const Half other = besideGone(mesh, rim, stays);
  const Half outRim = oppositeOf(mesh, rim), outOther = oppositeOf(mesh, other);
  const bool fixed = constrained(mesh, rim) || constrained(mesh, other);
  save(mesh, apex, log);
  for (const Half out : {outRim, outOther}) {
    if (!out.exists()) continue;
    save(mesh, triangleOf(out), log);
    mesh.triangles[triangleOf(out)].adj[cornerOf(out)] = out == outRim ? outOther : outRim;
    if (fixed) constrain(mesh, out);
    mesh.vertexTriangle[apex] = triangleOf(out);
    mesh.vertexTriangle[stays] = triangleOf(out);
    mesh.tested[triangleOf(out)] = 0;
    noteTouched(mesh, triangleOf(out));
  }
  killTriangle(mesh, triangleOf(rim), log);
}

}  // namespace

bool collapseEdge(Mesh& mesh, Vertex gone, Vertex stays, EditLog& log) {
  Star around, beyond;
  starOf(mesh, gone, around);
  starOf(mesh, stays, beyond);
  const bool boundary = mesh.vertexEdge[gone].exists();
  const bool border = boundary && !around.closed;
  if (!boundary && !around.closed) return false;
  Half after, before;  // rims of the triangles beside the edge: begins, ends at `stays`
  for (const Half rim : around.rim) {
    if (startOf(mesh, rim) == stays) after = rim;
    if (endOf(mesh, rim) == stays) before = rim;
  }
  if (!after.exists() && !before.exists()) return false;
  const bool borderEdge = !after.exists() || !before.exists();
  // A vertex of an inner chain is merged along the chain.
  if (boundary && !border && (borderEdge || !constrained(mesh, spokeTo(after)))) return false;
  if (border != borderEdge || around.rim.size() < (border ? 2u : 3u)) return false;
  if (commonNeighbours(mesh, around, beyond, stays) != (borderEdge ? 1 : 2)) return false;
  for (const Half side : {after, before})
    if (side.exists() && !oppositeOf(mesh, side).exists() && !oppositeOf(mesh, besideGone(mesh, side, stays)).exists())
      return false;
  save(mesh, stays, log);
  save(mesh, gone, log);
  for (const Half side : {after, before})
    if (side.exists()) closeTriangle(mesh, side, stays, log);
  for (const Half rim : around.rim) {
    if (rim == after || rim == before) continue;
    const Slot slot = triangleOf(rim);
    save(mesh, slot, log);
    mesh.triangles[slot].v[cornerOf(rim)] = stays;
    mesh.ids[slot] = mesh.nextId++;
    mesh.tested[slot] = 0;
    mesh.vertexTriangle[stays] = slot;
    noteTouched(mesh, slot);
  }
  if (boundary) mergeBoundaryEdges(mesh, gone, log);
  mesh.kinds[gone] = VertexKind::removed;
  mesh.vertexTriangle[gone] = {};
  return true;
}

}  // namespace triscope
