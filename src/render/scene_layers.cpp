#include "render/scene_layers.h"

#include "core/base/stands_by_ids.h"
#include "core/words/settings.h"

namespace triscope::detail {
namespace {

LayerKey cellsKey(const SceneInput& in, const KeyStart& start) {
  const MeshState& state = in.state;
  const ViewOptions& o = in.options;
  LayerKey key = start.run;
  // The tree is complete after the density stage: later ticks show the same one.
  key << state.tree.cells.size() << (makesDensity(state.stage) ? state.tick : ~0ull);
  return key << o.quadtree << o.cells << o.outsideCells << o.triangulation << state.mesh.triangles.empty()
             << (o.fill == TriangleFill::plain);
}

LayerKey meshKey(const SceneInput& in, const KeyStart& start) {
  const ViewOptions& o = in.options;
  LayerKey key = start.moment;
  key << o.triangulation << o.helpers << o.fill << o.obtuse << o.quadtree << o.cells;
  return key << o.brush.on << o.brush.measure << o.brush.low << o.brush.high;
}

LayerKey boundaryKey(const SceneInput& in, const KeyStart& start) {
  LayerKey key = start.run;
  return key << in.options.boundary;
}

LayerKey pointsKey(const SceneInput& in, const KeyStart& start) {
  LayerKey key = start.moment;
  return key << in.options.boundaryPoints << in.options.steiner << in.state.boundary.size();
}

LayerKey frontsKey(const SceneInput& in, const KeyStart& start) {
  LayerKey key = start.moment;
  return key << in.options.fronts << in.state.front1.size() << in.state.front2.size();
}

LayerKey degreesKey(const SceneInput& in, const KeyStart& start) {
  LayerKey key = start.moment;
  return key << in.options.degrees;
}

LayerKey constraintsKey(const SceneInput& in, const KeyStart& start) {
  LayerKey key = start.run;
  return key << in.options.constraints << in.state.constraints.size();
}

LayerKey decisionKey(const SceneInput& in, const KeyStart& start) {
  LayerKey key = start.moment;
  key << in.options.decision << in.options.labels << (in.current != nullptr) << (in.insertion != nullptr);
  if (const Event* const event = in.current)
    key << event->kind << event->subject << event->vertex << event->created << event->at;
  if (in.insertion != nullptr) key << in.insertion->phase << in.insertion->insertion->event.vertex;
  return key;
}

LayerKey worstKey(const SceneInput& in, const KeyStart& start) {
  LayerKey key = start.moment;
  key << in.options.worst << in.options.labels << (in.quality != nullptr);
  if (const Quality* const q = in.quality) key << q->aspectAt << q->areaRatioAt << q->edgeRatioAt;
  return key;
}

LayerKey selectionKey(const SceneInput& in, const KeyStart& start) {
  const Selection& selection = in.options.selection;
  LayerKey key = start.moment;
  return key << selection.kind << selection.index << selection.edge;
}

constexpr std::array<LayerPart, kLayerCount> kParts{
    LayerPart{LayerId::cells, cellsKey, buildCells},
    LayerPart{LayerId::mesh, meshKey, buildMesh, patchMesh},
    LayerPart{LayerId::boundary, boundaryKey, buildBoundary},
    LayerPart{LayerId::points, pointsKey, buildPoints},
    LayerPart{LayerId::fronts, frontsKey, buildFronts},
    LayerPart{LayerId::degrees, degreesKey, buildDegrees},
    LayerPart{LayerId::constraints, constraintsKey, buildConstraints},
    LayerPart{LayerId::decision, decisionKey, buildDecision},
    LayerPart{LayerId::worst, worstKey, buildWorst},
    LayerPart{LayerId::selection, selectionKey, buildSelection},
};

static_assert(standsByIds(kParts));

}  // namespace

KeyStart keyStartOf(const SceneInput& in) {
  const MeshState& state = in.state;
  LayerKey run;
  for (const SettingInfo& info : settingTable()) run << settingValue(state.settings, info);
  run << state.minEdge << in.domainHash << in.options.theme << in.options.scale << in.options.dimmed;
  LayerKey moment = run;
  moment << state.tick << state.stage << state.mesh.points.size() << state.mesh.nextId << state.mesh.liveCount();
  return {run, moment};
}

const std::array<LayerPart, kLayerCount>& layerParts() { return kParts; }

}  // namespace triscope::detail
