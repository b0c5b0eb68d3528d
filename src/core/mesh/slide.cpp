#include "core/mesh/slide.h"

#include "core/base/assert.h"
#include "core/mesh/edit.h"

namespace triscope {

std::optional<OnCurve> onCurve(const Mesh& mesh, Vertex vertex) {
  if (mesh.kinds[vertex] <= VertexKind::kept) return std::nullopt;
  const EdgeId one = mesh.vertexEdge[vertex];
  if (!one.exists()) return std::nullopt;
  const EdgeId two = nextEdgeAt(mesh, one, vertex);
  if (!two.exists() || nextEdgeAt(mesh, two, vertex).exists()) return std::nullopt;
  const BoundaryEdge& a = mesh.edges[one];
  const BoundaryEdge& b = mesh.edges[two];
  if (a.curve != b.curve) return std::nullopt;
  const bool oneFirst = a.v1 == vertex;
  const BoundaryEdge& before = oneFirst ? a : b;
  const BoundaryEdge& after = oneFirst ? b : a;
  if (before.v1 != vertex || after.v0 != vertex) return std::nullopt;
  return OnCurve{oneFirst ? one : two, oneFirst ? two : one, before.curve, before.t1};
}

void slideVertex(Mesh& mesh, Vertex vertex, const OnCurve& from, double t, Point at, EditLog& log) {
  movePoint(mesh, vertex, at, log);
  save(mesh, from.before, log);
  save(mesh, from.after, log);
  mesh.edges[from.before].t1 = t;
  mesh.edges[from.after].t0 = t;
}

void mergeBoundaryEdges(Mesh& mesh, Vertex vertex, EditLog& log) {
  const std::optional<OnCurve> place = onCurve(mesh, vertex);
  TRISCOPE_CHECK(place.has_value(), "edges of one curve are merged");
  const BoundaryEdge rest = mesh.edges[place->after];
  save(mesh, vertex, log);
  save(mesh, rest.v1, log);
  save(mesh, place->before, log);
  save(mesh, place->after, log);
  // In the list of the far end the edge that stays takes the place of the one that goes.
  EdgeId* link = &mesh.vertexEdge[rest.v1];
  while (*link != place->after) {
    TRISCOPE_CHECK(link->exists(), "a boundary edge is in the lists of both its ends");
    save(mesh, *link, log);
    BoundaryEdge& step = mesh.edges[*link];
    link = step.v0 == rest.v1 ? &step.next0 : &step.next1;
  }
  *link = place->before;
  BoundaryEdge& merged = mesh.edges[place->before];
  merged.v1 = rest.v1;
  merged.t1 = rest.t1;
  merged.next1 = rest.next1;
  mesh.edges[place->after] = {};
  mesh.vertexEdge[vertex] = {};
}

}  // namespace triscope
