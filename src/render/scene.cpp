#include "render/scene.h"

#include <algorithm>
#include <bit>
#include <type_traits>

#include "render/scene_parts.h"

namespace triscope {
namespace {

// Tells two contents apart; not a digest of the state, which would cost as much as building the layer.
class Key {
 public:
  template <class T>
  Key& operator<<(T value) {
    if constexpr (std::is_same_v<T, double>) {
      add(std::bit_cast<std::uint64_t>(value));
    } else {
      add(static_cast<std::uint64_t>(value));
    }
    return *this;
  }
  Key& operator<<(const Point& p) { return *this << p.x << p.y; }
  [[nodiscard]] std::uint64_t value() const { return hash_ | 1u; }  // 0 means never built

 private:
  void add(std::uint64_t word) {
    hash_ = (hash_ ^ word) * 0x9E3779B97F4A7C15ull;
    hash_ ^= hash_ >> 32u;
  }
  std::uint64_t hash_ = 0xCBF29CE484222325ull;
};

// The run: domain, settings and Δx decide everything that follows.
Key runKey(const MeshState& state, const ViewOptions& options) {
  Key key;
  for (const SettingInfo& info : settingTable()) key << settingValue(state.settings, info);
  key << state.minEdge;
  if (state.domain) {
    key << state.domain->curves.size() << state.domain->loops.size() << state.domain->bounds.lo
        << state.domain->bounds.hi;
    for (const char c : state.domain->name) key << c;
    for (const char c : state.domain->file) key << c;
    for (const Curve& curve : state.domain->curves) key << curve.a;
    for (const DensityRequest& request : state.domain->density)
      key << request.at << request.to << request.rank << request.length;
  }
  key << options.theme << options.scale << options.dimmed;
  return key;
}

Key meshKey(Key key, const MeshState& state) {
  return key << state.tick << state.stage << state.mesh.points.size() << state.mesh.nextId << state.mesh.liveCount();
}

void fade(Color& c) { c = faded(c, 0.35); }

void dim(Layer& layer) {
  for (auto& batch : layer.squares) {
    fade(batch.outline.color);
    for (auto& square : batch.squares) fade(square.fill);
  }
  for (auto& batch : layer.triangles) {
    fade(batch.wire.color);
    for (Color& c : batch.fills) fade(c);
  }
  for (auto& batch : layer.lines) fade(batch.style.color);
  for (auto& circle : layer.circles) fade(circle.style.color);
  for (auto& batch : layer.marks) {
    fade(batch.fill);
    fade(batch.outline);
  }
  for (auto& label : layer.labels) fade(label.color);
}

std::size_t markedIn(const Layer& mesh, const Theme& theme) {
  std::size_t marked = 0;
  for (const TriangleBatch& batch : mesh.triangles)
    marked += static_cast<std::size_t>(std::count(batch.fills.begin(), batch.fills.end(), theme.selection));
  return marked;
}

std::array<std::uint64_t, kLayerCount> layerKeys(const MeshState& state, const ViewOptions& o, const Event* current,
                                                 const Quality* quality, const InsertionView* insertion) {
  const Key run = runKey(state, o);
  const Key mesh = meshKey(run, state);
  std::array<std::uint64_t, kLayerCount> keys{};
  const auto set = [&keys](LayerId id, Key key) { keys[static_cast<std::size_t>(id)] = (key << id).value(); };

  Key cells = run;
  // The tree is complete after the density stage: later ticks show the same one.
  cells << state.tree.cells.size() << (state.stage <= Stage::density ? state.tick : ~0ull);
  set(LayerId::cells, cells << o.quadtree << o.cells << o.outsideCells << o.triangulation
                            << state.mesh.triangles.empty() << (o.fill == TriangleFill::plain));

  Key triangles = mesh;
  triangles << o.triangulation << o.helpers << o.fill << o.obtuse << o.quadtree << o.cells;
  set(LayerId::mesh, triangles << o.brush.on << o.brush.measure << o.brush.low << o.brush.high);

  Key boundary = run;
  set(LayerId::boundary, boundary << o.boundary << o.triangulation << state.mesh.triangles.empty());

  Key points = mesh;
  set(LayerId::points, points << o.boundaryPoints << o.steiner << state.boundary.size());

  Key fronts = mesh;
  set(LayerId::fronts, fronts << o.fronts << state.front1.size() << state.front2.size());

  Key constraints = run;
  set(LayerId::constraints, constraints << o.constraints << state.constraints.size());

  Key decision = mesh;
  decision << o.decision << o.labels << (current != nullptr);
  if (current != nullptr)
    decision << current->kind << current->subject << current->vertex << current->created << current->at;
  decision << (insertion != nullptr);
  if (insertion != nullptr) decision << insertion->phase << insertion->insertion->event.vertex;
  set(LayerId::decision, decision);

  Key worst = mesh;
  worst << o.worst << o.labels << (quality != nullptr);
  if (quality != nullptr) worst << quality->aspectAt << quality->areaRatioAt << quality->edgeRatioAt;
  set(LayerId::worst, worst);

  Key selection = mesh;
  set(LayerId::selection, selection << o.selection.kind << o.selection.index << o.selection.edge);
  return keys;
}

}  // namespace

DashPattern patternOf(Dash dash) {
  switch (dash) {
    case Dash::solid:
      break;
    case Dash::dashed:
      return {{6.0f, 4.0f, 0.0f, 0.0f}, 2};
    case Dash::dash_dotted:
      return {{8.0f, 3.0f, 1.5f, 3.0f}, 4};
    case Dash::dotted:
      return {{1.2f, 2.8f, 0.0f, 0.0f}, 2};
  }
  return {};
}

void updateScene(Scene& scene, const MeshState& state, const ViewOptions& options, const Event* current,
                 const Quality* quality, const InsertionView* insertion) {
  scene.theme = themeOf(options.theme);
  scene.bounds = state.domain ? state.domain->bounds : Box{};
  scene.origin = scene.bounds.empty() ? Point{} : midpoint(scene.bounds.lo, scene.bounds.hi);

  using Build = void (*)(const detail::SceneInput&, Layer&);
  static constexpr std::array<Build, kLayerCount> parts{
      detail::buildCells,    detail::buildMesh,   detail::buildBoundary,
      detail::buildPoints,   detail::buildFronts, detail::buildConstraints,
      detail::buildDecision, detail::buildWorst,  detail::buildSelection};
  const detail::SceneInput in{state, options, scene.theme, current, quality, insertion};
  const auto keys = layerKeys(state, options, current, quality, insertion);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Layer& layer = scene.layers[i];
    if (layer.key == keys[i]) continue;
    layer = Layer{};
    parts[i](in, layer);
    if (static_cast<LayerId>(i) == LayerId::mesh) scene.brushed = options.brush.on ? markedIn(layer, scene.theme) : 0;
    if (options.dimmed) dim(layer);
    layer.key = keys[i];
  }
  scene.legend = detail::buildLegend(in, scene.brushed);
}

Scene buildScene(const MeshState& state, const ViewOptions& options, const Event* current, const Quality* quality) {
  Scene scene;
  updateScene(scene, state, options, current, quality);
  return scene;
}

}  // namespace triscope
