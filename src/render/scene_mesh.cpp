// The triangulation: what Figure 4 shows. Linear passes over flat arrays, no allocation per element.
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/density/wanted.h"
#include "core/geometry/predicates.h"
#include "core/mesh/edit.h"
#include "core/mesh/inside_box.h"
#include "render/scene_parts.h"

namespace triscope::detail {
namespace {

using std::size_t;

/// As measure() counts them: by the exact sign.
bool isObtuse(const Mesh& mesh, const Triangle& t) {
  const Point a = mesh.points[t.v[0]], b = mesh.points[t.v[1]], c = mesh.points[t.v[2]];
  return dotSign(a, b, c) < 0 || dotSign(b, c, a) < 0 || dotSign(c, a, b) < 0;
}

/// What triangles are filled with.
class Fills {
 public:
  explicit Fills(const SceneInput& in) : in_(in) {
    const bool cellsShow = drawsCells(in) && in.options.cells != CellColoring::none;
    plain_ = cellsShow ? Color{0, 0, 0, 0} : in.theme.domainFill;
    if (in.options.fill == TriangleFill::density) ranks_ = rankRange(in.state.tree);
  }

  /// The same for all triangles.
  [[nodiscard]] bool alike() const {
    return in_.options.fill == TriangleFill::plain && !in_.options.obtuse && !in_.options.brush.on;
  }
  [[nodiscard]] Color plain() const { return plain_; }
  /// Whether a triangle's depends on its neighbours.
  [[nodiscard]] bool ofPairs() const {
    const ViewOptions& o = in_.options;
    return o.fill == TriangleFill::area_ratio || (o.brush.on && o.brush.measure == TriangleFill::area_ratio);
  }

  [[nodiscard]] Color of(Slot slot) const {
    const ViewOptions& o = in_.options;
    if (o.brush.on) {
      const auto low = static_cast<double>(static_cast<float>(o.brush.low));  // the least value is its own bar's end
      const auto value = static_cast<double>(measureSlot(in_.state, slot, o.brush.measure));
      if (value >= low && value <= o.brush.high) return in_.theme.selection;
    }
    if (o.obtuse && isObtuse(in_.state.mesh, triangleAt(in_.state.mesh, slot))) return in_.theme.obtuse;
    if (o.fill == TriangleFill::plain) return plain_;
    const float value = measureSlot(in_.state, slot, o.fill);
    if (o.fill == TriangleFill::density)
      return rankColor(o.scale, in_.theme, static_cast<int>(value), ranks_.lowest, ranks_.highest);
    return measureColor(o, in_.theme, static_cast<double>(value));
  }

 private:
  const SceneInput& in_;
  Color plain_;
  RankRange ranks_;
};

constexpr Index3 kHole{0, 0, 0};

Index3 cornersOf(const Triangle& t) { return {t.v[0].word(), t.v[1].word(), t.v[2].word()}; }

/// A triangle for each slot, and room for slots to come.
void fillBySlot(const SceneInput& in, TriangleBatch& batch) {
  const Mesh& mesh = in.state.mesh;
  const InsideBox inside(mesh);
  const Fills fills(in);
  batch.triangles.resize(mesh.triangles.size() + mesh.triangles.size() / 64 + 64, kHole);
  if (!fills.alike()) batch.fills.resize(batch.triangles.size(), fills.plain());
  for (size_t slot = 0; slot < mesh.triangles.size(); ++slot) {
    const Slot here(slot);
    if (!inside.has(here)) continue;
    batch.triangles[slot] = cornersOf(mesh.triangles[here]);
    if (!fills.alike()) batch.fills[slot] = fills.of(here);
  }
  if (fills.alike() && fills.plain().a > 0) batch.fills.push_back(fills.plain());
}

/// The triangles that there are, and the edges.
void fillOnce(const SceneInput& in, TriangleBatch& inner, TriangleBatch& helper) {
  const Mesh& mesh = in.state.mesh;
  const InsideBox inside(mesh);
  const Fills fills(in);
  inner.triangles.reserve(mesh.liveCount());
  inner.edges.reserve(mesh.liveCount() * 3 / 2 + 64);
  if (fills.alike() && fills.plain().a > 0) inner.fills.push_back(fills.plain());
  for (const Slot slot : mesh.triangles.keys()) {
    if (!mesh.alive(slot)) continue;
    const Triangle& t = mesh.triangles[slot];
    const bool outer = !inside.has(slot);
    if (!outer) {
      inner.triangles.push_back(cornersOf(t));
      if (!fills.alike()) inner.fills.push_back(fills.of(slot));
    }
    for (int i = 0; i < 3; ++i) {
      if (t.adj[i] > halfOf(slot, i)) continue;  // the other side names this edge
      const Vertex a = t.v[next3(i)];
      const Vertex b = t.v[prev3(i)];
      const bool outerEdge = outer && (mesh.kinds[a] == VertexKind::helper || mesh.kinds[b] == VertexKind::helper);
      (outerEdge ? helper : inner).edges.push_back({a.word(), b.word()});
    }
  }
}

/// Which points lie elsewhere than they did; empty when none does. One that is new belongs to new triangles only.
std::vector<std::uint8_t> movedPoints(const std::vector<Point>& before, const std::vector<Point>& now) {
  std::vector<std::uint8_t> moved;
  const size_t both = std::min(before.size(), now.size());
  for (size_t v = 0; v < both; ++v) {
    if (before[v] == now[v]) continue;
    if (moved.empty()) moved.resize(std::max(before.size(), now.size()), 0);
    moved[v] = 1;
  }
  return moved;
}

/// Triangles of a batch by slot that are not as they are in the mesh; nothing when they are more than a few.
std::optional<std::vector<std::uint32_t>> differing(const TriangleBatch& batch, const Mesh& mesh,
                                                    const InsideBox& inside) {
  constexpr size_t kMost = 4096;
  const std::vector<std::uint8_t> moved = movedPoints(batch.points, mesh.points);
  std::vector<std::uint32_t> slots;
  for (size_t slot = 0; slot < batch.triangles.size(); ++slot) {
    const bool there = slot < mesh.triangles.size() && inside.has(Slot(slot));
    const Index3 now = there ? cornersOf(mesh.triangles[Slot(slot)]) : kHole;
    if (now == batch.triangles[slot] && (!there || moved.empty() || !(moved[now[0]] | moved[now[1]] | moved[now[2]])))
      continue;
    if (slots.size() == kMost) return std::nullopt;
    slots.push_back(static_cast<std::uint32_t>(slot));
  }
  return slots;
}

void addNeighbours(std::vector<std::uint32_t>& slots, const Mesh& mesh) {
  for (size_t k = slots.size(); k-- > 0;) {
    if (slots[k] >= mesh.triangles.size()) continue;
    for (const Half half : mesh.triangles[Slot(slots[k])].adj)
      if (half.exists()) slots.push_back(triangleOf(half).word());
  }
}

}  // namespace

Color measureColor(const ViewOptions& options, const Theme& theme, double value) {
  const MeasureScale scale = scaleOf(options.fill);
  const double t = (value - scale.good) / (scale.bound - scale.good);  // 0 good, 1 at the bound
  if (t >= 1.0) return theme.overBound;
  return mix(theme.background, scaleColor(options.scale, theme.dark ? t : 1.0 - t), 0.82);
}

void buildMesh(const SceneInput& in, Layer& layer) {
  const Mesh& mesh = in.state.mesh;
  if (!in.options.triangulation || mesh.triangles.empty()) return;
  TriangleBatch inner;
  TriangleBatch helper;
  if (in.once)
    fillOnce(in, inner, helper);
  else
    fillBySlot(in, inner);
  inner.points = mesh.points;
  inner.wire = {in.theme.wire, 0.9f, Dash::solid, true};
  if (in.options.helpers && !helper.edges.empty()) {
    helper.points = mesh.points;
    helper.wire = {in.theme.helperWire, 0.7f, Dash::solid, true};
    layer.triangles.push_back(std::move(helper));
  }
  layer.triangles.push_back(std::move(inner));
}

bool patchMesh(const SceneInput& in, Layer& layer) {
  const Mesh& mesh = in.state.mesh;
  if (layer.triangles.size() != 1 || in.options.dimmed || !in.options.triangulation || mesh.triangles.empty())
    return false;
  TriangleBatch& batch = layer.triangles.front();
  const Fills fills(in);
  const bool alike = batch.fills.size() <= 1;
  if (mesh.triangles.size() > batch.triangles.size() || alike != fills.alike()) return false;
  if (alike && (batch.fills.empty() ? fills.plain().a > 0 : batch.fills.front() != fills.plain())) return false;
  const InsideBox inside(mesh);
  std::optional<std::vector<std::uint32_t>> slots = differing(batch, mesh, inside);
  if (!slots) return false;
  if (fills.ofPairs()) addNeighbours(*slots, mesh);

  Box where;
  const auto include = [&](const std::vector<Point>& points, const Index3& t) {
    if (t == kHole) return;
    for (const std::uint32_t v : t) where.include(points[v]);
  };
  for (const std::uint32_t slot : *slots) include(batch.points, batch.triangles[slot]);
  for (const std::uint32_t slot : *slots) {
    const Slot here(slot);
    const bool there = slot < mesh.triangles.size() && inside.has(here);
    batch.triangles[slot] = there ? cornersOf(mesh.triangles[here]) : kHole;
    include(mesh.points, batch.triangles[slot]);
    if (there && !alike) batch.fills[slot] = fills.of(here);
    if (!there && !alike) batch.fills[slot] = fills.plain();
  }
  batch.points = mesh.points;
  layer.change.triangles = std::move(*slots);
  layer.change.where = where;
  return true;
}

}  // namespace triscope::detail
