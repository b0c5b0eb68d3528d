#include "core/io/report.h"

#include "core/base/index_text.h"
#include "core/base/json_text.h"
#include "core/base/version.h"
#include "core/method/pipeline.h"
#include "core/method/size_fit.h"

namespace triscope {
namespace {

/// One JSON object, a member a line.
class ObjectText {
 public:
  explicit ObjectText(int indent) : indent_(indent) {}
  void add(std::string_view key, std::string value) {
    text_ += fmt::format("{}\n{:{}}{}: {}", text_.empty() ? "" : ",", "", indent_ + 2, jsonText(key), value);
  }
  void add(std::string_view key, double value) { add(key, jsonNumber(value)); }
  void add(std::string_view key, std::size_t value) { add(key, fmt::format("{}", value)); }
  void add(std::string_view key, bool value) { add(key, std::string(value ? "true" : "false")); }
  [[nodiscard]] std::string str() const { return fmt::format("{{{}\n{:{}}}}", text_, "", indent_); }

 private:
  int indent_;
  std::string text_;
};

void addMeasures(ObjectText& out, const Quality& q) {
  out.add("aspect_ratio_max", q.aspectMax);
  out.add("area_ratio_max", q.areaRatioMax);
  out.add("edge_ratio_max", q.edgeRatioMax);
  out.add("min_angle_deg", q.minAngle);
  out.add("max_angle_deg", q.maxAngle);
  out.add("obtuse", q.obtuse);
  out.add("min_edge_length", q.minEdge);
  out.add("area", q.area);
  out.add("aspect_ratio_mean", q.aspectMean);
}

void addVerdict(ObjectText& out, const Mesh& mesh, const Quality& q) {
  ObjectText worst(2);
  const auto addWorst = [&](std::string_view key, Slot slot) {
    worst.add(key, !slot.exists() ? std::string("null") : fmt::format("{}", idOf(mesh, slot)));
  };
  addWorst("aspect_ratio", q.aspectAt);
  addWorst("area_ratio", q.areaRatioAt);
  addWorst("area_ratio_neighbour", q.areaRatioOther);
  addWorst("edge_ratio", q.edgeRatioAt);
  addWorst("min_angle", q.minAngleAt);
  addWorst("max_angle", q.maxAngleAt);
  addWorst("min_edge_length", q.minEdgeAt);
  out.add("worst", worst.str());

  ObjectText bounds(2);
  const auto addBound = [&](std::string_view key, double limit, bool met) {
    bounds.add(key, fmt::format("{{\"limit\": {}, \"met\": {}}}", jsonNumber(limit), met));
  };
  addBound("aspect_ratio", Bounds::aspect, q.aspectMax < Bounds::aspect);
  addBound("area_ratio", Bounds::areaRatio, q.areaRatioMax < Bounds::areaRatio);
  addBound("edge_ratio", Bounds::edgeRatio, q.edgeRatioMax < Bounds::edgeRatio);
  addBound("min_angle", Bounds::minAngle, q.minAngle > Bounds::minAngle);
  addBound("max_angle", Bounds::maxAngle, q.maxAngle < Bounds::maxAngle);
  out.add("bounds", bounds.str());
  out.add("bounds_met", q.withinBounds());
}

std::string stageList(const MeshState& state, const StageSeconds& seconds) {
  std::string list;
  for (const Stage id : state.method->stages) {
    const StageInfo& stage = infoOf(id);
    const auto index = static_cast<std::size_t>(id);
    const StageCounts& counts = state.counts[index];
    list += fmt::format(
        "{}\n    {{\"key\": {}, \"name\": {}, \"seconds\": {}, \"decisions\": {}, \"inserted\": {}, \"refused\": {}, "
        "\"moved\": {}, \"removed\": {}}}",
        list.empty() ? "" : ",", jsonText(stage.key), jsonText(stage.name), jsonNumber(seconds[index]),
        counts.decisions, counts.inserted, counts.refused, counts.moved, counts.removed);
  }
  return "[" + list + "\n  ]";
}

}  // namespace

std::string reportOf(const Mesh& mesh, const Quality& quality) {
  ObjectText out(0);
  out.add("vertices", quality.vertices);
  out.add("triangles", quality.triangles);
  out.add("boundary_vertices", quality.boundaryVertices);
  addMeasures(out, quality);
  addVerdict(out, mesh, quality);
  return out.str() + "\n";
}

std::string reportOf(const MeshState& state, const Quality& quality, const StageSeconds& seconds) {
  ObjectText out(0);
  const MadeBy now = thisVersion();
  out.add("program_version", jsonText(now.program));
  out.add("method_version", fmt::format("{}", now.method));
  out.add("domain", jsonText(state.domain != nullptr ? state.domain->name : ""));
  out.add("vertices", quality.vertices);
  out.add("triangles", quality.triangles);
  out.add("boundary_vertices", quality.boundaryVertices);
  out.add("estimated_triangles", state.estimatedTriangles);
  addMeasures(out, quality);
  const SizeFit fit = sizeFitOf(state);
  out.add("edge_over_h_mean", fit.mean);
  out.add("edge_over_h_within", fit.within);
  out.add("min_edge", state.minEdge);
  out.add("min_edge_derived", state.minEdgeDerived);
  addVerdict(out, state.mesh, quality);
  out.add("rounds", std::size_t{state.roundsDone});
  out.add("passes", std::size_t{state.passesDone} + (refinesMesh(state.stage) ? state.round : 0u));
  out.add("failed", state.failed);
  out.add("stages", stageList(state, seconds));
  return out.str() + "\n";
}

}  // namespace triscope
