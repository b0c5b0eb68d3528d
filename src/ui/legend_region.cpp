// The legend: at the foot of the right column, or over the picture where the column is too narrow for it.
#include "render/legend_panel.h"
#include "ui/imgui_canvas.h"
#include "ui/panels.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace triscope {
namespace {

constexpr double kPadding = 12.0;  // pixels at 100 %

void drawItems(const View& view, ImVec2 at) {
  ImGuiCanvas canvas(*ImGui::GetWindowDrawList(), view.fonts);
  drawLegend(view.scene.legend, {static_cast<double>(at.x), static_cast<double>(at.y)}, view.ui.scale(), view.theme(),
             canvas);
}

}  // namespace

ImVec2 legendNeeds(const View& view) {
  if (!view.ui.look.legend || view.scene.legend.empty()) return {0, 0};
  const LegendSize size = legendSize(view.scene.legend, view.ui.scale());
  return {static_cast<float>(size.width) + 2 * view.px(kPadding),
          static_cast<float>(size.height) + 2 * view.px(kPadding)};
}

void drawLegendRegion(const View& view, Orders&) {
  const ImVec2 corner = ImGui::GetWindowPos();
  const float width = ImGui::GetWindowWidth();
  ImGui::GetWindowDrawList()->AddLine(corner, {corner.x + width, corner.y}, ImGui::GetColorU32(ImGuiCol_Separator));
  ImGui::Dummy(ImGui::GetContentRegionAvail());
  note(view, "legend");
  drawItems(view, {corner.x + view.px(kPadding), corner.y + view.px(kPadding)});
}

void overlayLegend(const View& view, ImVec2 corner, ImVec2 size) {
  const ImVec2 needed = legendNeeds(view);
  const float margin = view.px(10);
  // Where it would cover most of the picture, the picture matters more.
  if (needed.y <= 0.0f || needed.x + 2 * margin > 0.6f * size.x || needed.y + 2 * margin > size.y) return;
  const ImVec2 lo{corner.x + size.x - needed.x - margin, corner.y + margin};
  const ImVec2 hi{lo.x + needed.x, lo.y + needed.y};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(lo, hi, toImU32(faded(view.theme().surface, 0.96)), view.px(6));
  list.AddRect(lo, hi, ImGui::GetColorU32(ImGuiCol_Border), view.px(6));
  drawItems(view, {lo.x + view.px(kPadding), lo.y + view.px(kPadding)});
}

}  // namespace triscope
