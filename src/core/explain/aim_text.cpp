#include "core/explain/aim_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>

#include "core/base/shown_text.h"
#include "core/domain/loop_of.h"
#include "core/explain/bound_text.h"
#include "core/explain/fields.h"
#include "core/mesh/centroid.h"
#include "core/mesh/edit.h"
#include "core/optimise/penalty.h"
#include "core/quality/bound_figure.h"

namespace triscope {
namespace {

constexpr std::size_t kPlaces = 5;

/// An input angle below 60° that the triangle lies in, or else touches.
std::optional<InputAngle> inputAngleAt(const Mesh& mesh, Slot slot) {
  if (const std::optional<InputAngle> own = smallInputAngle(mesh, slot)) return own;
  Star star;
  for (const Vertex v : triangleAt(mesh, slot).v) {
    if (!mesh.vertexEdge[v].exists()) continue;
    starOf(mesh, v, star);
    for (const Half rim : star.rim) {
      const std::optional<InputAngle> angle = smallInputAngle(mesh, triangleOf(rim));
      if (angle && angle->at == pointOf(mesh, v)) return angle;
    }
  }
  return std::nullopt;
}

/// The corner of the input, or else the boundary, that the vertex is on.
std::string featureAt(const MeshState& state, Vertex v) {
  const Mesh& mesh = state.mesh;
  const EdgeId edge = mesh.vertexEdge[v];
  if (!edge.exists()) return {};
  const std::string name = shown(loopOf(*state.domain, mesh.edges[edge].curve).name);
  return mesh.kinds[v] == VertexKind::kept ? fmt::format("the point {} of '{}'", placeText(pointOf(mesh, v)), name)
                                           : fmt::format("'{}'", name);
}

/// What is fixed and nearest to a triangle: at one of its corners, or an edge further; empty where nothing is.
std::string featureNear(const MeshState& state, Slot slot) {
  const Mesh& mesh = state.mesh;
  std::string near;
  const auto look = [&](Vertex v) {
    const std::string feature = featureAt(state, v);
    if (!feature.empty() && (near.empty() || mesh.kinds[v] == VertexKind::kept)) near = feature;
  };
  for (const Vertex v : triangleAt(mesh, slot).v) look(v);
  if (!near.empty()) return near;
  Star star;
  for (const Vertex v : triangleAt(mesh, slot).v) {
    starOf(mesh, v, star);
    for (const Half rim : star.rim) look(startOf(mesh, rim));
  }
  return near;
}

std::string whereText(const MeshState& state, Slot slot) {
  if (const std::optional<InputAngle> angle = inputAngleAt(state.mesh, slot)) return inputAngleText(*angle);
  const std::string place = fmt::format("at {}", placeText(centroidOf(state.mesh, slot)));
  const std::string feature = featureNear(state, slot);
  return feature.empty() ? place : place + " beside " + feature;
}

bool isOptimised(const MeshState& state) { return state.settings.optimise && state.stage > Stage::optimise; }

}  // namespace

std::vector<std::string> unmetAimTexts(const MeshState& state, const Quality& q) {
  if (!isOptimised(state) || q.triangles == 0) return {};
  const Aims aims = aimsOf(state.settings), slack = withSlack(aims);
  struct Row {
    const char* name;
    double value, aim;
    bool met, withinBound;
    Slot slot;
    int decimals;
  };
  const std::array rows{
      Row{"smallest angle", q.minAngle, aims.lowestAngle, q.minAngle >= slack.lowestAngle,
          q.minAngle > Bounds::minAngle, q.minAngleAt, 1},
      Row{"largest angle", q.maxAngle, aims.highestAngle, q.maxAngle <= slack.highestAngle,
          q.maxAngle < Bounds::maxAngle, q.maxAngleAt, 1},
      Row{"area ratio", q.areaRatioMax, aims.areaRatio, q.areaRatioMax <= slack.areaRatio,
          q.areaRatioMax < Bounds::areaRatio, q.areaRatioAt, 2},
      Row{"edge ratio", q.edgeRatioMax, aims.edgeRatio, q.edgeRatioMax <= slack.edgeRatio,
          q.edgeRatioMax < Bounds::edgeRatio, q.edgeRatioAt, 2},
  };
  std::vector<std::string> texts;
  for (const Row& row : rows) {
    if (row.met || !row.withinBound || !row.slot.exists()) continue;
    texts.push_back(fmt::format("{} {}, not {:g}, {}", row.name, besideBound(row.value, row.aim, row.decimals), row.aim,
                                whereText(state, row.slot)));
  }
  return texts;
}

std::string obtuseText(const MeshState& state, const Quality& quality) {
  if (!isOptimised(state) || quality.obtuse == 0) return {};
  std::map<std::string, std::size_t> counts;
  for (const Slot slot : state.mesh.triangles.keys()) {
    if (!state.mesh.alive(slot) || !qualityOf(state.mesh, slot).obtuse) continue;
    ++counts[whereText(state, slot)];
  }
  std::vector<std::pair<std::size_t, std::string>> places;
  places.reserve(counts.size());
  for (const auto& [where, count] : counts) places.emplace_back(count, where);
  std::ranges::sort(places, [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first > b.first : a.second < b.second;
  });
  std::string text = fmt::format("{} obtuse triangle{}: ", quality.obtuse, quality.obtuse == 1 ? "" : "s");
  for (std::size_t k = 0; k < std::min(kPlaces, places.size()); ++k)
    text += fmt::format("{}{} {}", k == 0 ? "" : ", ", places[k].first, places[k].second);
  if (places.size() > kPlaces) text += fmt::format(", and {} places more", places.size() - kPlaces);
  return text;
}

}  // namespace triscope
