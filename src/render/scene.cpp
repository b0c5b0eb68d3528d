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

std::size_t markedIn(const Layer& mesh, const Theme& theme) {
  std::size_t marked = 0;
  for (const TriangleBatch& batch : mesh.triangles)
    marked += static_cast<std::size_t>(std::count(batch.fills.begin(), batch.fills.end(), theme.selection));
  return marked;
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

  // The scene holds on to the domain that was hashed, so that no other can come to stand in its place.
  if (scene.domain != state.domain) {
    scene.domain = state.domain;
    scene.domainHash = state.domain ? hashOf(*state.domain) : 0;
  }

  const detail::SceneInput in{state, options, scene.theme, scene.domainHash, current, quality, insertion};
  const detail::KeyStart start = detail::keyStartOf(in);
  for (const detail::LayerPart& part : detail::layerParts()) {
    Layer& layer = scene.layers[static_cast<std::size_t>(part.id)];
    const std::uint64_t key = (part.key(in, start) << part.id).value();
    if (layer.key == key) continue;
    layer = Layer{};
    part.build(in, layer);
    if (part.id == LayerId::mesh) scene.brushed = options.brush.on ? markedIn(layer, scene.theme) : 0;
    if (options.dimmed) dim(layer);
    layer.key = key;
  }
  scene.legend = detail::buildLegend(in, scene.brushed);
}

Scene buildScene(const MeshState& state, const ViewOptions& options, const Event* current, const Quality* quality) {
  Scene scene;
  updateScene(scene, state, options, current, quality);
  return scene;
}

}  // namespace triscope
