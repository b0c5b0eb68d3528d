// The figures of the mesh as a whole, held against the paper's bounds.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "core/base/number.h"
#include "core/quality/bound_figure.h"
#include "ui/kit/style.h"
#include "ui/kit/widgets.h"
#include "ui/panel/panels.h"

namespace triscope {
namespace {

struct Row {
  const char* label;
  std::string value;
  std::string bound;
  bool good;
  std::optional<Action> show;
};

void drawEstimate(const View& view, const MeshState& state) {
  if (state.estimatedTriangles <= 0.0) return;
  figure(view, "estimate by Table 1", grouped(static_cast<std::uint64_t>(std::llround(state.estimatedTriangles))));
}

}  // namespace

void drawMeshFigures(const View& view, Orders& orders) {
  heading(view, "Mesh");
  const Snapshot* const now = view.now();
  if (now == nullptr || now->quality.triangles == 0) {
    muted(view, "There are no triangles yet.");
    if (now != nullptr) drawEstimate(view, now->state);
    return;
  }
  const Quality& q = now->quality;
  figure(view, "triangles", grouped(q.triangles));
  drawEstimate(view, now->state);
  figure(view, "vertices", grouped(q.vertices));
  figure(view, "boundary vertices", grouped(q.boundaryVertices));
  figure(view, "obtuse",
         fmt::format("{}  ({:.1f} %)", grouped(q.obtuse),
                     100.0 * static_cast<double>(q.obtuse) / static_cast<double>(q.triangles)));
  figure(view, "mean aspect ratio", fmt::format("{:.3f}", q.aspectMean));
  figure(view, "shortest edge", compact(q.minEdge, 4));

  const std::array<Row, 5> rows{{
      {"aspect ratio", besideBound(q.aspectMax, Bounds::aspect, 2), "< 4.31", q.aspectMax < Bounds::aspect,
       Action::worst_aspect},
      {"area ratio", besideBound(q.areaRatioMax, Bounds::areaRatio, 2), "< 3", q.areaRatioMax < Bounds::areaRatio,
       Action::worst_area},
      {"edge ratio", besideBound(q.edgeRatioMax, Bounds::edgeRatio, 2), "< 2", q.edgeRatioMax < Bounds::edgeRatio,
       Action::worst_edge},
      {"smallest angle",
       besideBound(q.minAngle, Bounds::minAngle, 1) + "°",
       "> 30°",
       q.minAngle > Bounds::minAngle,
       {}},
      {"largest angle",
       besideBound(q.maxAngle, Bounds::maxAngle, 1) + "°",
       "< 120°",
       q.maxAngle < Bounds::maxAngle,
       {}},
  }};
  const bool wide = ImGui::GetContentRegionAvail().x >= view.px(230);  // room for the bounds themselves
  if (!ImGui::BeginTable("bounds", wide ? 4 : 3, ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_SizingStretchProp))
    return;
  ImGui::TableSetupColumn("worst of", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthFixed);
  if (wide) ImGui::TableSetupColumn("bound", ImGuiTableColumnFlags_WidthFixed);
  ImGui::TableSetupColumn("met", ImGuiTableColumnFlags_WidthFixed);
  for (const Row& row : rows) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    if (row.show) {
      if (link(view, row.label)) orders.emplace_back(*row.show);
      tip(view, "Frame and select the triangle that has it.");
    } else {
      ImGui::TextUnformatted(row.label);
    }
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(row.value.c_str());
    if (wide) {
      ImGui::TableNextColumn();
      ImGui::TextDisabled("%s", row.bound.c_str());
    }
    ImGui::TableNextColumn();
    const Color sign = row.good ? view.theme().front1 : view.theme().worstAspect;
    ImGui::TextColored(toImVec4(sign), "%s", row.good ? "\xE2\x9C\x93" : "\xE2\x9C\x97");
  }
  ImGui::EndTable();
}

}  // namespace triscope
