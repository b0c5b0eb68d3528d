#include "core/explain/caption.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/capitalised.h"
#include "core/base/counted.h"
#include "core/explain/fields.h"
#include "core/method/estimate.h"
#include "core/method/pipeline.h"
#include "core/quality/bound_figure.h"
#include "core/words/vocabulary.h"

namespace triscope {
namespace {

struct Leaves {
  std::uint64_t cells = 0;
  int lowest = 0;  // density ranks among those that the domain meets
  int highest = 0;
};

Leaves leavesOf(const Quadtree& tree) {
  Leaves leaves;
  for (const Cell& cell : tree.cells) {
    if (cell.child >= 0) continue;
    ++leaves.cells;
    if (cell.type == CellType::outside) continue;
    leaves.lowest = leaves.lowest == 0 ? cell.density : std::min<int>(leaves.lowest, cell.density);
    leaves.highest = std::max<int>(leaves.highest, cell.density);
  }
  return leaves;
}

std::size_t atBox(const Mesh& mesh) {
  std::size_t count = 0;
  for (const Slot slot : mesh.triangles.keys())
    if (mesh.alive(slot) && touchesHelper(mesh, slot)) ++count;
  return count;
}

}  // namespace

std::string captionOf(const Event& e) {
  const KindWords& kind = wordsOf(e.kind);
  const std::string_view ofRule = kind.captionOfRule == nullptr ? "" : wordsOf(e.rule).*kind.captionOfRule;
  return filled(ofRule.empty() ? kind.caption : ofRule, e);
}

std::string captionOf(const Event& e, const MeshState& state) {
  const std::string stage = capitalised(infoOf(e.stage).name);
  const std::string triangles = counted(state.mesh.liveCount(), "triangle", "triangles");
  switch (e.stage) {
    case Stage::constraints:
      return fmt::format("{} are done: {} found, Δx = {}.", stage, grouped(state.constraints.size()),
                         shortNumber(state.minEdge));
    case Stage::quadtree:
      return fmt::format("{} is done: {}.", stage, counted(leavesOf(state.tree).cells, "leaf cell", "leaf cells"));
    case Stage::density: {
      const Leaves leaves = leavesOf(state.tree);
      return fmt::format(
          "{} is done: {}, ranks {}–{}, {} estimated, {} of memory.", stage,
          counted(leaves.cells, "leaf cell", "leaf cells"), leaves.lowest, leaves.highest,
          counted(static_cast<std::uint64_t>(std::llround(state.estimatedTriangles)), "triangle", "triangles"),
          bytesText(estimateOf(state).bytes));
    }
    case Stage::boundary:
      return fmt::format(
          "{} are done: {} placed between those of the input.", stage,
          std::count_if(state.boundary.begin(), state.boundary.end(), [](const BoundaryPoint& p) { return !p.kept; }));
    case Stage::triangulation:
      return fmt::format("{} is done: {}, {} at the box around the domain and others outside it among them.", stage,
                         triangles, grouped(atBox(state.mesh)));
    case Stage::recovery:
      return e.subject == 0 ? fmt::format("{} is done: no boundary edge was missing.", stage)
                            : fmt::format("{} is done: {} split.", stage, counted(e.subject, "edge was", "edges were"));
    case Stage::carve:
      return fmt::format("{} is done: {} outside gave way, {} stay.", stage, grouped(e.subject),
                         grouped(state.mesh.liveCount()));
    case Stage::repair:
      if (e.subject == 0) return fmt::format("{} is done: nothing was mended; {}.", stage, triangles);
      return fmt::format("{} is done: {}, {}.", stage, counted(e.subject, "edit", "edits"), triangles);
    case Stage::finished:
      break;
    default:  // fronts, steps
      if (refinesMesh(e.stage) || optimisesMesh(e.stage))
        return fmt::format("{} is done: {} in it, {}.", stage, counted(e.subject, "change", "changes"), triangles);
      if (e.subject == 0) return fmt::format("{} is done: it had nothing to change; {}.", stage, triangles);
      return fmt::format("{} is done: {} inserted, {}.", stage, counted(e.subject, "point", "points"), triangles);
  }
  return {};
}

std::string summaryOf(const MeshState& state, const Quality& q) {
  if (state.failed && state.estimatedTriangles > state.settings.maxTriangles)
    return fmt::format("Stopped before a mesh of about {} triangles was made: {} are allowed.",
                       roughCount(state.estimatedTriangles),
                       grouped(static_cast<std::uint64_t>(state.settings.maxTriangles)));
  if (state.failed)
    return fmt::format("The method stopped in {}; the mesh is shown as it was then.", infoOf(state.stage).name);
  const std::string stage = capitalised(infoOf(state.stage).name);
  if (state.stage != Stage::finished) {
    if (state.cursor.begun) return fmt::format("{} goes on.", stage);
    return fmt::format("{} comes next: it {}.", stage, infoOf(state.stage).does);
  }
  return fmt::format(
      "Finished after {}: {}, {} of them obtuse. {} of the paper: aspect {}, area ratio {}, edge ratio {}, angles from "
      "{}° to {}°.",
      counted(state.tick, "decision", "decisions"), counted(q.triangles, "triangle", "triangles"),
      q.obtuse == 0 ? std::string("none") : grouped(q.obtuse),
      q.withinBounds() ? "Within all bounds" : "Not within all bounds", besideBound(q.aspectMax, Bounds::aspect, 2),
      besideBound(q.areaRatioMax, Bounds::areaRatio, 2), besideBound(q.edgeRatioMax, Bounds::edgeRatio, 2),
      besideBound(q.minAngle, Bounds::minAngle, 1), besideBound(q.maxAngle, Bounds::maxAngle, 1));
}

}  // namespace triscope
