#include "core/io/mesh_from.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "core/base/index_text.h"
#include "core/geometry/predicates.h"
#include "core/mesh/edit.h"

namespace triscope {
namespace {

/// A half-edge under the undirected edge it belongs to.
struct EdgeSide {
  Vertex low;
  Vertex high;
  Half half;
  bool operator<(const EdgeSide& other) const {
    return std::tie(low, high, half) < std::tie(other.low, other.high, other.half);
  }
};

Error badMesh(std::string message, std::string hint, Point place) {
  return {.message = std::move(message), .hint = std::move(hint), .file = {}, .loop = {}, .at = place};
}

std::string times(std::size_t count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

/// Pairs up half-edges; the sides come sorted.
Status linkSides(Mesh& mesh, const std::vector<EdgeSide>& sides) {
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i;
    while (end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high) ++end;
    const Point place = midpoint(pointOf(mesh, sides[i].low), pointOf(mesh, sides[i].high));
    if (end - i > 2) {
      return badMesh(fmt::format("edge {}-{} belongs to {} triangles", sides[i].low, sides[i].high, end - i),
                     "an edge of a plane mesh has at most two: remove the triangles that overlap", place);
    }
    if (end - i == 2) {
      if (startOf(mesh, sides[i].half) == startOf(mesh, sides[i + 1].half)) {
        return badMesh(fmt::format("triangles {} and {} lie on the same side of edge {}-{}", triangleOf(sides[i].half),
                                   triangleOf(sides[i + 1].half), sides[i].low, sides[i].high),
                       "remove the triangles that overlap", place);
      }
      link(mesh, sides[i].half, sides[i + 1].half);
    }
    i = end;
  }
  return success();
}

}  // namespace

Result<Mesh> meshFrom(const MeshFile& file, std::vector<std::string>* notes) {
  const auto note = [&](std::string text) {
    if (notes != nullptr) notes->push_back(std::move(text));
  };
  if (file.triangles.empty()) {
    return Error{
        .message = "there are no triangles", .hint = "the file holds no plane triangle mesh", .file = {}, .loop = {}};
  }
  Mesh mesh;
  for (const Point p : file.points) addVertex(mesh, p, VertexKind::steiner, 1);

  std::size_t turned = 0;
  std::vector<EdgeSide> sides;
  sides.reserve(3 * file.triangles.size());
  for (const auto& corners : file.triangles) {
    const Corners<Vertex> t{Vertex(corners[0]), Vertex(corners[1]), Vertex(corners[2])};
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) {
      return badMesh(fmt::format("triangle {} has the corners {}, {}, {}", mesh.triangles.size(), t[0], t[1], t[2]),
                     "a triangle needs three points: remove it", pointOf(mesh, t[0]));
    }
    const bool clockwise = orient2d(pointOf(mesh, t[0]), pointOf(mesh, t[1]), pointOf(mesh, t[2])) < 0;
    turned += clockwise ? 1u : 0u;
    const Slot slot = addTriangle(mesh, t[0], t[clockwise ? 2 : 1], t[clockwise ? 1 : 2]);
    for (const Half half : halvesOf(slot)) {
      const Vertex a = startOf(mesh, half), b = endOf(mesh, half);
      sides.push_back({std::min(a, b), std::max(a, b), half});
    }
  }
  std::sort(sides.begin(), sides.end());
  if (Status linked = linkSides(mesh, sides); !linked) return linked.error();

  std::size_t missing = 0;
  const auto makeBoundary = [&](Half half, Vertex v0, Vertex v1, std::uint32_t group) {
    if (constrained(mesh, half)) return;
    constrain(mesh, half);
    if (oppositeOf(mesh, half).exists()) constrain(mesh, oppositeOf(mesh, half));
    addBoundaryEdge(mesh, {.v0 = v0, .v1 = v1, .curve = group, .next0 = {}, .next1 = {}});
    for (const Vertex v : {v0, v1}) mesh.kinds[v] = VertexKind::boundary;
  };
  for (const MeshFile::Edge& edge : file.edges) {
    const Vertex low(std::min(edge.a, edge.b)), high(std::max(edge.a, edge.b));
    const auto side = std::lower_bound(sides.begin(), sides.end(), EdgeSide{low, high, {}});
    if (side == sides.end() || side->low != low || side->high != high) {
      ++missing;
    } else {
      makeBoundary(side->half, Vertex(edge.a), Vertex(edge.b), static_cast<std::uint32_t>(edge.group));
    }
  }
  for (const Half half : halvesOf(mesh)) {
    if (oppositeOf(mesh, half).exists()) continue;
    makeBoundary(half, startOf(mesh, half), endOf(mesh, half), static_cast<std::uint32_t>(file.groups.size()));
  }
  std::size_t unused = 0;
  for (const Vertex v : mesh.points.keys()) {
    if (mesh.vertexTriangle[v].exists()) continue;
    mesh.kinds[v] = VertexKind::removed;
    ++unused;
  }

  if (turned > 0) note(times(turned, "triangle") + " clockwise in the file, turned round");
  if (unused > 0) note(times(unused, "point") + " used by no triangle, left out");
  if (missing > 0) note(times(missing, "edge") + " listed in the file but no edge of a triangle, left out");
  return mesh;
}

}  // namespace triscope
