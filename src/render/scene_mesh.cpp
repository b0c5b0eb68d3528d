// The triangulation and its points: what Figure 4 shows. Linear passes over flat arrays, no allocation per element.
#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/density/wanted.h"
#include "render/boundary_points.h"
#include "render/scene_parts.h"

namespace triscope::detail {
namespace {

using std::size_t;

size_t at(std::int32_t i) { return static_cast<size_t>(i); }

double areaOf(const Mesh& mesh, const Triangle& t) {
  const Point a = mesh.points[at(t.v[0])];
  return 0.5 * cross(mesh.points[at(t.v[1])] - a, mesh.points[at(t.v[2])] - a);
}

bool touchesHelper(const Mesh& mesh, const Triangle& t) {
  return std::any_of(t.v.begin(), t.v.end(),
                     [&mesh](std::int32_t v) { return mesh.kinds[at(v)] == VertexKind::helper; });
}

bool isObtuse(const Mesh& mesh, const Triangle& t) {
  for (int i = 0; i < 3; ++i) {
    const Point p = mesh.points[at(t.v[at(i)])];
    if (dot(mesh.points[at(t.v[at(next3(i))])] - p, mesh.points[at(t.v[at(prev3(i))])] - p) < 0.0) return true;
  }
  return false;
}

float measureOne(const Mesh& mesh, const Triangle& t, TriangleFill fill) {
  const TriangleQuality q = qualityOf(mesh.points[at(t.v[0])], mesh.points[at(t.v[1])], mesh.points[at(t.v[2])]);
  switch (fill) {
    case TriangleFill::aspect:
      return static_cast<float>(q.aspect);
    case TriangleFill::min_angle:
      return static_cast<float>(q.minAngle);
    case TriangleFill::max_angle:
      return static_cast<float>(q.maxAngle);
    case TriangleFill::edge_ratio:
      return static_cast<float>(q.edgeRatio);
    case TriangleFill::plain:
    case TriangleFill::area_ratio:
    case TriangleFill::density:
      break;
  }
  return 0.0f;
}

std::vector<float> areaRatios(const Mesh& mesh) {
  std::vector<double> area(mesh.triangles.size(), 0.0);
  for (size_t i = 0; i < area.size(); ++i) {
    if (mesh.alive(static_cast<std::int32_t>(i))) area[i] = areaOf(mesh, mesh.triangles[i]);
  }
  std::vector<float> ratio(area.size(), 0.0f);
  for (size_t i = 0; i < area.size(); ++i) {
    if (area[i] <= 0.0) continue;
    double worst = 1.0;
    for (const std::int32_t half : mesh.triangles[i].adj) {
      if (half < 0) continue;
      const double other = area[at(triangleOf(half))];
      if (other > 0.0) worst = std::max({worst, other / area[i], area[i] / other});
    }
    ratio[i] = static_cast<float>(worst);
  }
  return ratio;
}

// Typical distance to the neighbours of a vertex, from the density rank where it was placed.
float spacingOf(const MeshState& state, std::int32_t vertex) {
  return static_cast<float>(edgeLengthOf(state.tree, std::max<int>(1, state.mesh.density[at(vertex)])));
}

MarkBatch markBatch(Shape shape, float size, Color fill, Color outline) {
  MarkBatch batch;
  batch.shape = shape;
  batch.size = size;
  batch.fill = fill;
  batch.outline = outline;
  return batch;
}

void addFills(const SceneInput& in, TriangleBatch& batch, const std::vector<std::int32_t>& slots) {
  const Mesh& mesh = in.state.mesh;
  const ViewOptions& o = in.options;
  const bool cellsShow = drawsCells(in) && o.cells != CellColoring::none;
  const Color plain = cellsShow ? Color{0, 0, 0, 0} : in.theme.domainFill;
  if (o.fill == TriangleFill::plain && !o.obtuse && !o.brush.on) {
    if (plain.a > 0) batch.fills.push_back(plain);
    return;
  }
  batch.fills.assign(slots.size(), plain);
  if (o.fill != TriangleFill::plain) {
    const std::vector<float> values = measureSlots(in.state, o.fill);
    if (o.fill == TriangleFill::density) {
      const RankRange range = rankRange(in.state.tree);
      for (size_t k = 0; k < slots.size(); ++k) {
        batch.fills[k] =
            rankColor(o.scale, in.theme, static_cast<int>(values[at(slots[k])]), range.lowest, range.highest);
      }
    } else {
      for (size_t k = 0; k < slots.size(); ++k) {
        batch.fills[k] = measureColor(o, in.theme, static_cast<double>(values[at(slots[k])]));
      }
    }
  }
  if (o.obtuse) {
    for (size_t k = 0; k < slots.size(); ++k) {
      if (isObtuse(mesh, mesh.triangles[at(slots[k])])) batch.fills[k] = in.theme.obtuse;
    }
  }
  if (o.brush.on) {
    const std::vector<float> values = measureSlots(in.state, o.brush.measure);
    const auto low = static_cast<double>(static_cast<float>(o.brush.low));  // the least value is its own bar's end
    for (size_t k = 0; k < slots.size(); ++k) {
      const auto value = static_cast<double>(values[at(slots[k])]);
      if (value >= low && value <= o.brush.high) batch.fills[k] = in.theme.selection;
    }
  }
}

}  // namespace

MeasureScale scaleOf(TriangleFill fill) {
  switch (fill) {
    case TriangleFill::aspect:
      return {2.0, Bounds::aspect};
    case TriangleFill::min_angle:
      return {60.0, Bounds::minAngle};
    case TriangleFill::max_angle:
      return {60.0, Bounds::maxAngle};
    case TriangleFill::area_ratio:
      return {1.0, Bounds::areaRatio};
    case TriangleFill::edge_ratio:
      return {1.0, Bounds::edgeRatio};
    case TriangleFill::plain:
    case TriangleFill::density:
      break;
  }
  return {};
}

std::vector<float> measureSlots(const MeshState& state, TriangleFill fill) {
  const Mesh& mesh = state.mesh;
  if (fill == TriangleFill::area_ratio) return areaRatios(mesh);
  std::vector<float> values(mesh.triangles.size(), 0.0f);
  for (size_t i = 0; i < values.size(); ++i) {
    if (!mesh.alive(static_cast<std::int32_t>(i))) continue;
    const Triangle& t = mesh.triangles[i];
    if (fill == TriangleFill::density) {
      const Point sum = mesh.points[at(t.v[0])] + mesh.points[at(t.v[1])] + mesh.points[at(t.v[2])];
      values[i] = static_cast<float>(wantedAt(state.tree, (1.0 / 3.0) * sum).value_or(Wanted{}).rank);
    } else {
      values[i] = measureOne(mesh, t, fill);
    }
  }
  return values;
}

Color measureColor(const ViewOptions& options, const Theme& theme, double value) {
  const MeasureScale scale = scaleOf(options.fill);
  const double t = (value - scale.good) / (scale.bound - scale.good);  // 0 good, 1 at the bound
  if (t >= 1.0) return theme.overBound;
  return mix(theme.background, scaleColor(options.scale, theme.dark ? t : 1.0 - t), 0.82);
}

void buildMesh(const SceneInput& in, Layer& layer) {
  const Mesh& mesh = in.state.mesh;
  if (!in.options.triangulation || mesh.triangles.empty()) return;
  const auto slotCount = static_cast<std::int32_t>(mesh.triangles.size());

  TriangleBatch inner;
  TriangleBatch helper;
  std::vector<std::int32_t> innerSlots;
  innerSlots.reserve(mesh.liveCount());
  inner.triangles.reserve(mesh.liveCount());
  inner.edges.reserve(mesh.liveCount() * 3 / 2 + 64);
  for (std::int32_t slot = 0; slot < slotCount; ++slot) {
    if (!mesh.alive(slot)) continue;
    const Triangle& t = mesh.triangles[at(slot)];
    const bool outer = touchesHelper(mesh, t);
    if (!outer) {
      inner.triangles.push_back(
          {static_cast<std::uint32_t>(t.v[0]), static_cast<std::uint32_t>(t.v[1]), static_cast<std::uint32_t>(t.v[2])});
      innerSlots.push_back(slot);
    }
    for (int i = 0; i < 3; ++i) {
      if (t.adj[at(i)] > 3 * slot + i) continue;  // the other side names this edge
      const std::int32_t a = t.v[at(next3(i))];
      const std::int32_t b = t.v[at(prev3(i))];
      const bool outerEdge =
          outer && (mesh.kinds[at(a)] == VertexKind::helper || mesh.kinds[at(b)] == VertexKind::helper);
      (outerEdge ? helper : inner).edges.push_back({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)});
    }
  }
  addFills(in, inner, innerSlots);
  inner.points = mesh.points;
  inner.wire = {in.theme.wire, 0.9f, Dash::solid, true};
  if (in.options.helpers && !helper.edges.empty()) {
    helper.points = mesh.points;
    helper.wire = {in.theme.helperWire, 0.7f, Dash::solid, true};
    layer.triangles.push_back(std::move(helper));
  }
  layer.triangles.push_back(std::move(inner));
}

void buildPoints(const SceneInput& in, Layer& layer) {
  const MeshState& state = in.state;
  const Theme& theme = in.theme;
  MarkBatch placed = markBatch(Shape::circle, 4.0f, theme.placed, {0, 0, 0, 0});
  MarkBatch kept = markBatch(Shape::square, 5.0f, theme.kept, {0, 0, 0, 0});
  MarkBatch split = markBatch(Shape::ring, 5.5f, theme.placed, {0, 0, 0, 0});
  MarkBatch steiner = markBatch(Shape::triangle, 5.5f, theme.steiner, {0, 0, 0, 0});
  const auto add = [](MarkBatch& batch, Point p, float spacing) {
    batch.at.push_back(p);
    batch.spacing.push_back(spacing);
  };
  if (in.options.boundaryPoints && state.mesh.points.empty()) {
    for (const size_t index : distinctBoundaryPoints(state)) {
      const BoundaryPoint& p = state.boundary[index];
      add(p.kept ? kept : placed, p.at, static_cast<float>(wantedAt(state.tree, p.at).value_or(Wanted{}).length));
    }
  }
  for (size_t i = 0; i < state.mesh.points.size(); ++i) {
    const VertexKind kind = state.mesh.kinds[i];
    if (kind < VertexKind::kept || kind > VertexKind::steiner) continue;
    const bool onBoundary = kind <= VertexKind::split;
    const bool wanted = onBoundary ? in.options.boundaryPoints : in.options.steiner && kind == VertexKind::steiner;
    if (!wanted) continue;
    MarkBatch& batch = kind == VertexKind::kept       ? kept
                       : kind == VertexKind::boundary ? placed
                       : kind == VertexKind::split    ? split
                                                      : steiner;
    add(batch, state.mesh.points[i], spacingOf(state, static_cast<std::int32_t>(i)));
  }
  for (MarkBatch* batch : {&steiner, &placed, &split, &kept}) {
    if (!batch->at.empty()) layer.marks.push_back(std::move(*batch));
  }
}

std::vector<std::int32_t> frontInMesh(const Mesh& mesh, const std::vector<std::int32_t>& front) {
  std::vector<std::int32_t> there;
  std::copy_if(front.begin(), front.end(), std::back_inserter(there), [&mesh](std::int32_t vertex) {
    return vertex >= 0 && at(vertex) < mesh.points.size() && mesh.kinds[at(vertex)] != VertexKind::removed;
  });
  return there;
}

void buildFronts(const SceneInput& in, Layer& layer) {
  if (!in.options.fronts) return;
  const Mesh& mesh = in.state.mesh;
  const auto add = [&](const std::vector<std::int32_t>& front, Shape shape, float size, Color color) {
    MarkBatch batch = markBatch(shape, size, color, in.theme.background);
    for (const std::int32_t vertex : frontInMesh(mesh, front)) {
      batch.at.push_back(mesh.points[at(vertex)]);
      batch.spacing.push_back(spacingOf(in.state, vertex));
    }
    if (!batch.at.empty()) layer.marks.push_back(std::move(batch));
  };
  add(in.state.front1, Shape::circle, 7.0f, in.theme.front1);
  add(in.state.front2, Shape::diamond, 8.5f, in.theme.front2);
}

}  // namespace triscope::detail
