#include "render/scene.h"

#include <algorithm>

#include "core/domain/domain_hash.h"
#include "render/scene_layers.h"

namespace triscope {
namespace {

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

bool sameContent(const Layer& a, const Layer& b) {
  return a.squares == b.squares && a.triangles == b.triangles && a.lines == b.lines && a.circles == b.circles &&
         a.marks == b.marks && a.labels == b.labels;
}

void countMarked(Scene& scene, const detail::SceneInput& in, const Layer& mesh) {
  scene.brushed = 0;
  if (!in.options.brush.on) return;
  for (const TriangleBatch& batch : mesh.triangles)
    scene.brushed += static_cast<std::size_t>(std::count(batch.fills.begin(), batch.fills.end(), in.theme.selection));
}

/// Builds a layer, or mends the one from before.
void updateLayer(Scene& scene, const detail::SceneInput& in, const detail::LayerPart& part, std::uint64_t style) {
  Layer& layer = scene.layers[static_cast<std::size_t>(part.id)];
  const bool mended = part.patch != nullptr && layer.style == style && !in.once && part.patch(in, layer);
  if (!mended) {
    Layer built;
    part.build(in, built);
    if (part.id == LayerId::mesh) countMarked(scene, in, built);
    if (in.options.dimmed) dim(built);
    built.style = style;
    built.version = layer.version;
    const bool same = layer.key != 0 && sameContent(layer, built);
    layer = std::move(built);
    if (same) return;
  } else {
    countMarked(scene, in, layer);
  }
  layer.change.since = mended ? layer.version : 0;
  layer.version = ++scene.versions;
}

void update(Scene& scene, const MeshState& state, const ViewOptions& options, const Event* current,
            const Quality* quality, const InsertionView* insertion, bool once) {
  scene.theme = themeOf(options.theme);
  scene.bounds = state.domain ? state.domain->bounds : Box{};
  scene.origin = scene.bounds.empty() ? Point{} : midpoint(scene.bounds.lo, scene.bounds.hi);

  // The scene holds on to the domain that was hashed, so that no other can come to stand in its place.
  if (scene.domain != state.domain) {
    scene.domain = state.domain;
    scene.domainHash = state.domain ? hashOf(*state.domain) : 0;
  }

  const detail::SceneInput in{state, options, scene.theme, scene.domainHash, current, quality, insertion, once};
  const detail::KeyStart start = detail::keyStartOf(in);
  for (const detail::LayerPart& part : detail::layerParts()) {
    Layer& layer = scene.layers[static_cast<std::size_t>(part.id)];
    const std::uint64_t key = (part.key(in, start) << part.id).value();
    if (layer.key == key) continue;
    updateLayer(scene, in, part, part.key(in, {start.run, start.run}).value());
    layer.key = key;
  }
  scene.legend = detail::buildLegend(in, scene);
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
  update(scene, state, options, current, quality, insertion, false);
}

Scene buildScene(const MeshState& state, const ViewOptions& options, const Event* current, const Quality* quality) {
  Scene scene;
  update(scene, state, options, current, quality, nullptr, true);
  return scene;
}

}  // namespace triscope
