// The legend: at the foot of the right column; else over the picture where it leaves enough of it; else a button there.
#include <algorithm>

#include "render/legend_panel.h"
#include "ui/imgui_canvas.h"
#include "ui/panels.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace triscope {
namespace {

constexpr double kPadding = 12.0;  // pixels at 100 %
constexpr double kMargin = 10.0;
constexpr float kMostCovered = 0.125f;  // of a picture
constexpr const char* kFolded = "Legend";

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

bool legendMayCover(const View& view, ImVec2 size) {
  const ImVec2 needed = legendNeeds(view);
  const float margin = 2 * view.px(kMargin);
  return needed.x + margin <= size.x && needed.y + margin <= size.y &&
         needed.x * needed.y <= kMostCovered * size.x * size.y;
}

void overlayLegend(const View& view, ImVec2 corner, ImVec2 size) {
  const ImVec2 needed = legendNeeds(view);
  if (needed.y <= 0.0f) return;
  const float margin = view.px(kMargin);
  const ImVec2 lo{corner.x + size.x - needed.x - margin, corner.y + margin};
  const ImVec2 hi{lo.x + needed.x, lo.y + needed.y};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(lo, hi, toImU32(faded(view.theme().surface, 0.96)), view.px(6));
  list.AddRect(lo, hi, ImGui::GetColorU32(ImGuiCol_Border), view.px(6));
  drawItems(view, {lo.x + view.px(kPadding), lo.y + view.px(kPadding)});
}

void drawFoldedLegend(const View& view, Orders& orders, ImVec2 corner, ImVec2 size) {
  const float margin = view.px(kMargin);
  const float width = ImGui::CalcTextSize(kFolded).x + 2.0f * ImGui::GetStyle().FramePadding.x;
  // Even a button would be too much: there are the key and the menu.
  if (width * ImGui::GetFrameHeight() > 0.5f * kMostCovered * size.x * size.y) return;
  ImGui::SetCursorScreenPos({corner.x + size.x - width - margin, corner.y + margin});
  // A window of its own takes the mouse from the picture below.
  bool hovered = false;
  if (ImGui::BeginChild("folded", {width, ImGui::GetFrameHeight()}, false, ImGuiWindowFlags_NoScrollbar)) {
    if (ImGui::Button(kFolded)) orders.emplace_back(Action::legend);
    note(view, "legend.folded");
    hovered = ImGui::IsItemHovered();
  }
  ImGui::EndChild();
  if (!view.ui.legendOver && (view.ui.tipsWait || !hovered)) return;
  // Below the button, or as far up as it needs to be whole.
  const ImVec2 needed = legendNeeds(view);
  const float below = corner.y + 2.0f * margin + ImGui::GetFrameHeight();
  const float top = std::max(0.0f, std::min(below, ImGui::GetIO().DisplaySize.y - needed.y));
  if (beginFloating(view, "##legend over", {corner.x + size.x - margin, top}, {1.0f, 0.0f}, needed.x)) {
    const ImVec2 at = ImGui::GetWindowPos();
    ImGui::Dummy({needed.x - 2 * view.px(kPadding), needed.y - 2 * view.px(kPadding)});
    note(view, "legend.over");
    drawItems(view, {at.x + view.px(kPadding), at.y + view.px(kPadding)});
  }
  endFloating();
}

}  // namespace triscope
