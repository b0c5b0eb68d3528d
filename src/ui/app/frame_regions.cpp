#include "ui/app/frame_regions.h"

#include <algorithm>
#include <array>
#include <string>

#include "ui/kit/widgets.h"
#include "ui/panel/panels.h"
#include "ui/region/regions.h"

namespace triscope {
namespace {

// A column that has given way to the canvas is narrower than this, in pixels.
constexpr float kNarrowest = 2.0f;

void drawFixed(const Layout& layout, const View& shown, Orders& orders) {
  struct Fixed {
    const char* name;
    const Region& region;
    ImVec2 padding;
    void (*draw)(const View&, Orders&);
    bool sunken;
  };
  const std::array<Fixed, 4> fixed{{
      {"##toolbar", layout.toolbar, {shown.px(10), shown.px(8)}, drawToolbar, false},
      {"##canvas", layout.canvas, {0, 0}, drawCanvas, true},
      {"##caption", layout.caption, {shown.px(12), shown.px(9)}, drawCaption, false},
      {"##status", layout.status, {shown.px(12), shown.px(5)}, drawStatusBar, false},
  }};
  for (const Fixed& part : fixed) {
    const ImGuiWindowFlags flags = part.sunken ? ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoBackground : 0;
    if (beginRegion(part.name, part.region, part.padding, flags)) part.draw(shown, orders);
    ImGui::End();
  }
}

/// One column of tabs; those of one side, or of both.
void drawSide(Parts& parts, const char* name, std::optional<Side> side, const Region& region, Orders& orders) {
  if (region.size.x < kNarrowest) return;
  const View shown = viewOf(parts);
  UiState& ui = parts.desk.ui;
  constexpr ImGuiTabBarFlags kTabs = ImGuiTabBarFlags_FittingPolicyScroll | ImGuiTabBarFlags_NoTooltip;
  if (beginRegion(name, region, {shown.px(10), shown.px(6)}) && ImGui::BeginTabBar("tabs", kTabs)) {
    for (const PanelInfo& panel : panels()) {
      if (side ? panel.side != *side : panel.side == Side::bottom) continue;
      const ImGuiTabItemFlags flags = parts.wantedTab == panel.id ? ImGuiTabItemFlags_SetSelected : 0;
      const bool open = ImGui::BeginTabItem(panel.name, nullptr, flags);
      note(shown, std::string("tab.") + panel.name);
      if (!open) continue;
      if (!parts.wantedTab) (panel.side == Side::left ? ui.tab : ui.debug.rightTab) = panel.id;
      if (ImGui::BeginChild("content", {0, 0}, false)) panel.draw(shown, orders);
      ImGui::EndChild();
      ImGui::EndTabItem();
    }
    ImGui::EndTabBar();
  }
  ImGui::End();
}

void drawBottom(const Layout& layout, const View& shown, Orders& orders) {
  if (beginRegion("##timeline", layout.timeline, {shown.px(12), shown.px(5)})) drawTimeline(shown, orders);
  ImGui::End();
  if (layout.bottom.size.y <= 0.0f) return;
  if (beginRegion("##bottom", layout.bottom, {shown.px(12), shown.px(6)}) && shown.ui.debug.bottom)
    infoOf(*shown.ui.debug.bottom).draw(shown, orders);
  ImGui::End();
}

}  // namespace

void drawRegions(Parts& parts, const Layout& layout, Orders& orders) {
  const View shown = viewOf(parts);
  UiState& ui = parts.desk.ui;
  drawFixed(layout, shown, orders);
  if (layout.legend.size.y > 0.0f) {
    if (beginRegion("##legend", layout.legend, {0, 0})) drawLegendRegion(shown, orders);
    ImGui::End();
  }
  // With one column left, it has all the tabs.
  const bool both = layout.right.size.x >= kNarrowest;
  drawSide(parts, "##left", both ? std::optional(Side::left) : std::nullopt, layout.left, orders);
  if (both) drawSide(parts, "##right", Side::right, layout.right, orders);
  parts.wantedTab.reset();
  ui.sidePanelsShown = layout.left.size.x >= kNarrowest;
  drawBottom(layout, shown, orders);
  const bool typing = ImGui::GetIO().WantTextInput || ui.debug.bottom != Panel::breakpoints;
  ui.debug.typeSoon = typing ? 0 : std::max(0, ui.debug.typeSoon - 1);
  drawSplitters(shown, orders, layout);
  parts.dialogs.draw(shown, orders);
}

}  // namespace triscope
