#include "core/io/export.h"

#include <algorithm>
#include <optional>
#include <span>
#include <tuple>

#include "core/domain/loop_of.h"
#include "core/io/edge_groups.h"
#include "core/mesh/edit.h"
#include "core/mesh/inside_box.h"
#include "core/quality/running_quality.h"

namespace triscope {
namespace {

/// A point inside the closed polygon that these edges form: the middle of the widest inside stretch of a horizontal
/// line that passes no vertex.
std::optional<Point> insideOf(const MeshFile& file, std::span<const MeshFile::Edge> edges) {
  std::vector<double> levels;
  for (const MeshFile::Edge& edge : edges) levels.push_back(file.points[static_cast<std::size_t>(edge.a)].y);
  std::sort(levels.begin(), levels.end());
  double widestGap = 0.0;
  double level = 0.0;
  for (std::size_t i = 1; i < levels.size(); ++i) {
    if (levels[i] - levels[i - 1] > widestGap) {
      widestGap = levels[i] - levels[i - 1];
      level = levels[i - 1] + 0.5 * widestGap;
    }
  }
  std::vector<double> crossings;
  for (const MeshFile::Edge& edge : edges) {
    const Point a = file.points[static_cast<std::size_t>(edge.a)], b = file.points[static_cast<std::size_t>(edge.b)];
    if ((a.y > level) == (b.y > level)) continue;
    crossings.push_back(a.x + (level - a.y) / (b.y - a.y) * (b.x - a.x));
  }
  std::sort(crossings.begin(), crossings.end());
  std::optional<Point> inside;
  double widest = 0.0;
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
    if (crossings[i + 1] - crossings[i] > widest) {
      widest = crossings[i + 1] - crossings[i];
      inside = Point{crossings[i] + 0.5 * widest, level};
    }
  }
  return inside;
}

void exportEdges(const MeshState& state, const Per<Vertex, int>& number, MeshFile& file) {
  const Domain& domain = *state.domain;
  for (const Loop& loop : domain.loops) file.groups.push_back(loop.name);
  std::vector<BoundaryEdge> edges;
  for (const BoundaryEdge& edge : state.mesh.edges) {
    if (exists(edge) && number[edge.v0] >= 0 && number[edge.v1] >= 0) edges.push_back(edge);
  }
  std::sort(edges.begin(), edges.end(), [](const BoundaryEdge& x, const BoundaryEdge& y) {
    return std::tie(x.curve, x.t0, x.v0, x.v1) < std::tie(y.curve, y.t0, y.v0, y.v1);
  });
  for (const BoundaryEdge& edge : edges) {
    const auto group = static_cast<int>(&loopOf(domain, edge.curve) - domain.loops.data());
    file.edges.push_back({number[edge.v0], number[edge.v1], group});
  }
  const EdgeGroups groups(file);
  for (std::size_t loop = 0; loop < domain.loops.size(); ++loop) {
    if (domain.loops[loop].role != LoopRole::hole) continue;
    if (const auto inside = insideOf(file, groups.of(loop))) file.holes.push_back(*inside);
  }
}

/// The triangles to be written, by id. Ids are dense enough that putting each in its place beats sorting.
std::vector<Slot> slotsById(const Mesh& mesh) {
  Per<TriangleId, Slot> slots(mesh.nextId.n);
  const InsideBox inside(mesh);
  for (const Slot slot : mesh.triangles.keys())
    if (inside.has(slot)) slots[idOf(mesh, slot)] = slot;
  std::erase(slots, Slot());
  return slots;
}

void exportFields(const Mesh& mesh, const std::vector<Slot>& order, MeshFile& file) {
  file.fields = {{"id", {}},         {"aspect", {}},    {"area_ratio", {}},
                 {"edge_ratio", {}}, {"min_angle", {}}, {"max_angle", {}}};
  for (MeshFile::Field& field : file.fields) field.values.reserve(order.size());
  for (const Slot slot : order) {
    file.fields.front().values.push_back(static_cast<double>(idOf(mesh, slot).n));
    const MeasureValues values = measuresOf(mesh, slot);
    for (std::size_t i = 0; i < values.size(); ++i) file.fields[i + 1].values.push_back(values[i]);
  }
}

}  // namespace

MeshFile exportMesh(const MeshState& state, Fields fields) {
  const Mesh& mesh = state.mesh;
  MeshFile file;

  const std::vector<Slot> order = slotsById(mesh);
  Per<Vertex, int> number(mesh.points.size(), -1);
  for (const Slot slot : order)
    for (const Vertex v : triangleAt(mesh, slot).v) number[v] = 0;
  for (const Vertex v : number.keys()) {
    if (number[v] < 0) continue;
    number[v] = static_cast<int>(file.points.size());
    file.points.push_back(mesh.points[v]);
  }
  file.triangles.reserve(order.size());
  for (const Slot slot : order) {
    const auto& v = triangleAt(mesh, slot).v;
    file.triangles.push_back({number[v[0]], number[v[1]], number[v[2]]});
  }
  if (fields == Fields::yes) exportFields(mesh, order, file);
  if (state.domain != nullptr) exportEdges(state, number, file);
  return file;
}

}  // namespace triscope
