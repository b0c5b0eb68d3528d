// The legend: at the foot of the right column; else over the picture where it leaves enough of it; else a button there.
#include <algorithm>

#include "render/legend_panel.h"
#include "ui/kit/imgui_canvas.h"
#include "ui/kit/style.h"
#include "ui/kit/widgets.h"
#include "ui/region/regions.h"

namespace triscope {
namespace {

constexpr double kPadding = 12.0;  // pixels at 100 %
constexpr double kMargin = 10.0;
constexpr float kMostCovered = 0.125f;  // of a picture
constexpr float kMostLeft = 0.16f;      // where it is there already
constexpr const char* kFolded = "Legend";

ImVec2 foldedSize() {
  return {ImGui::CalcTextSize(kFolded).x + 2.0f * ImGui::GetStyle().FramePadding.x, ImGui::GetFrameHeight()};
}

/// Even a button would be too much for a small picture: there are the key and the menu.
bool isTooMuch(ImVec2 button, ImVec2 picture) {
  return button.x * button.y > 0.5f * kMostCovered * picture.x * picture.y;
}

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
  const float most = view.ui.legendPlace == LegendPlace::picture ? kMostLeft : kMostCovered;
  return needed.x + margin <= size.x && needed.y + margin <= size.y && needed.x * needed.y <= most * size.x * size.y;
}

Rect legendCovers(const View& view, ImVec2 size) {
  const ImVec2 covered = view.legendOnCanvas ? legendNeeds(view) : view.ui.legendFolded ? foldedSize() : ImVec2{0, 0};
  if (covered.x * covered.y <= 0.0f || (view.ui.legendFolded && isTooMuch(covered, size))) return {};
  const float margin = view.px(kMargin);
  return {static_cast<double>(size.x - covered.x - margin), static_cast<double>(margin), static_cast<double>(covered.x),
          static_cast<double>(covered.y)};
}

void overlayLegend(const View& view, ImVec2 corner, ImVec2 size) {
  const Rect covered = legendCovers(view, size);
  if (covered.height <= 0.0) return;
  const ImVec2 lo{corner.x + static_cast<float>(covered.x), corner.y + static_cast<float>(covered.y)};
  const ImVec2 hi{lo.x + static_cast<float>(covered.width), lo.y + static_cast<float>(covered.height)};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(lo, hi, toImU32(faded(view.theme().surface, 0.96)), view.px(6));
  list.AddRect(lo, hi, ImGui::GetColorU32(ImGuiCol_Border), view.px(6));
  drawItems(view, {lo.x + view.px(kPadding), lo.y + view.px(kPadding)});
}

void drawFoldedLegend(const View& view, Orders& orders, ImVec2 corner, ImVec2 size) {
  const float margin = view.px(kMargin);
  const ImVec2 button = foldedSize();
  if (isTooMuch(button, size)) return;
  ImGui::SetCursorScreenPos({corner.x + size.x - button.x - margin, corner.y + margin});
  // A window of its own takes the mouse from the picture below.
  bool hovered = false;
  if (ImGui::BeginChild("folded", button, false, ImGuiWindowFlags_NoScrollbar)) {
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
