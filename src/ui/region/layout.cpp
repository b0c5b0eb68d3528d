#include "ui/region/layout.h"

#include <algorithm>
#include <cmath>

#include "ui/kit/widgets.h"

namespace triscope {
namespace {

constexpr double kStatus = 30.0;  // heights and widths in pixels at 100 %
constexpr double kTimeline = 52.0;
constexpr double kLowTimeline = 34.0;  // where the window is low
constexpr double kLowForPanes = 500.0;
constexpr double kLowestBottom = 120.0;
constexpr double kSplitter = 6.0;
constexpr double kNarrowestSide = 180.0;
constexpr double kNarrowestCanvas = 196.0;
constexpr double kCanvasShare = 0.4;   // of the width, at least: else a side panel gives way
constexpr float kLegendShare = 0.5f;   // of the right column, at most
constexpr float kLegendLeft = 0.62f;   // where it is there already
constexpr double kNarrowLeft = 232.0;  // room for its tabs
constexpr double kNarrowRight = 200.0;
constexpr double kCaptionText = 1500.0;  // a long caption on one line
constexpr double kCaptionSides = 44.0;   // its padding and indent
constexpr double kCaptionLine = 17.0;
constexpr double kCaptionRest = 44.0;  // its heading and padding

/// `upright`: the border stands between left and right; `sign`: 1 where dragging right or down widens.
void splitter(const View& view, Orders& orders, const char* name, const Region& region, double Appearance::* width,
              double sign, bool upright = true) {
  if (region.size.x <= 0.0f || region.size.y <= 0.0f) return;
  if (!beginRegion(name, region, {0, 0}, ImGuiWindowFlags_NoBackground)) {
    ImGui::End();
    return;
  }
  ImGui::InvisibleButton("grip", region.size);
  note(view, name);
  const bool active = ImGui::IsItemActive();
  if (active || ImGui::IsItemHovered()) {
    ImGui::SetMouseCursor(upright ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
    const ImVec2 end{region.at.x + region.size.x, region.at.y + region.size.y};
    const float x = region.at.x + 0.5f * region.size.x;
    const float y = region.at.y + 0.5f * region.size.y;
    ImGui::GetWindowDrawList()->AddLine(upright ? ImVec2{x, region.at.y} : ImVec2{region.at.x, y},
                                        upright ? ImVec2{x, end.y} : ImVec2{end.x, y},
                                        ImGui::GetColorU32(ImGuiCol_SeparatorActive), view.px(2));
  }
  const ImVec2 delta = ImGui::GetIO().MouseDelta;
  const float along = upright ? delta.x : delta.y;
  if (active && along != 0.0f) {
    Appearance look = view.ui.look;
    const double moved = sign * static_cast<double>(along) / view.ui.scale();
    look.*width = std::clamp(look.*width + moved, upright ? kNarrowestSide : kLowestBottom, 900.0);
    orders.emplace_back(look);
  }
  ImGui::End();
}

}  // namespace

Layout layoutOf(ImVec2 window, float menu, float toolbar, ImVec2 legend, const UiState& ui) {
  const auto px = [&ui](double at100) { return std::round(static_cast<float>(at100 * ui.scale())); };
  const float splitter = px(kSplitter);
  const auto leaves = [&](double sides) {
    return window.x - px(sides) - 2 * splitter >= static_cast<float>(kCanvasShare) * window.x;
  };
  const bool one = leaves(kNarrowLeft);
  const bool both = leaves(kNarrowLeft + kNarrowRight);
  const bool shown = ui.sidePanels.value_or(one);
  float left = shown ? px(ui.look.leftWidth) : 0.0f;
  float right = shown && both ? px(ui.look.rightWidth) : 0.0f;
  const float least = std::max(px(kNarrowestCanvas), static_cast<float>(kCanvasShare) * window.x);
  const float room = std::max(0.0f, window.x - 2 * splitter - least);
  right = std::min(right, std::max(px(kNarrowRight), room - left));
  left = std::min(left, std::max(px(kNarrowLeft), room - right));
  left = std::min(left, std::floor(0.8f * window.x));  // asked for where there is no room: over most of the picture
  const float y = menu + toolbar;
  const float status = window.y - px(kStatus);
  const bool low = static_cast<double>(window.y) < kLowForPanes * ui.scale();
  const float timeline = px(low ? kLowTimeline : kTimeline);
  const float free = std::max(1.0f, status - y - timeline);
  const float panel =
      !ui.debug.bottom ? 0.0f : std::min(px(ui.look.bottomHeight), std::floor((low ? 0.5f : 0.6f) * free));
  const float border = panel > 0.0f ? splitter : 0.0f;
  const float bottom = status - timeline - panel - border;
  const float height = std::max(1.0f, bottom - y);
  const float middle = std::max(1.0f, window.x - left - right - 2 * splitter);
  // In a low window the caption goes under everything, so that it needs few lines.
  const float captionWidth = low ? window.x : middle;
  const double line = std::max(1.0, static_cast<double>(captionWidth) - kCaptionSides * ui.scale());
  const double lines = std::clamp(std::ceil(kCaptionText * ui.scale() / line), 2.0, 6.0);
  // A panel in a low window takes the caption's place.
  const float caption =
      low && panel > 0.0f ? 0.0f
                          : std::min(px(kCaptionRest + lines * kCaptionLine), std::floor((low ? 0.4f : 0.5f) * height));
  const float x = left + splitter;
  const float sides = low ? height - caption : height;
  // It does not come and go with each row.
  const bool there = ui.legendPlace == LegendPlace::column;
  const bool legendFits = (there || ui.legendPlace == LegendPlace::anywhere) && legend.y > 0.0f && legend.x <= right &&
                          legend.y <= (there ? kLegendLeft : kLegendShare) * sides;
  const float foot = legendFits ? legend.y : 0.0f;
  return {
      .toolbar = {{0, menu}, {window.x, toolbar}},
      .left = {{0, y}, {left, sides}},
      .right = {{x + middle + splitter, y}, {right, sides - foot}},
      .canvas = {{x, y}, {middle, height - caption}},
      .caption = {{low ? 0.0f : x, bottom - caption}, {captionWidth, caption}},
      .bottom = {{0, bottom + border}, {window.x, panel}},
      .timeline = {{0, status - timeline}, {window.x, timeline}},
      .status = {{0, status}, {window.x, px(kStatus)}},
      .legend = {{x + middle + splitter, y + sides - foot}, {legendFits ? right : 0.0f, foot}},
      .leftSplitter = {{left, y}, {splitter, sides}},
      .rightSplitter = {{x + middle, y}, {splitter, sides}},
      .bottomSplitter = {{0, bottom}, {window.x, border}},
  };
}

Panes panesOf(const Region& canvas, const UiState& ui) {
  if (!ui.pinned) return {{}, canvas};
  constexpr float kBetween = 2.0f;
  const float width = std::max(1.0f, std::floor(0.5f * (canvas.size.x - kBetween)));
  const float right = canvas.at.x + canvas.size.x - width;
  return {{canvas.at, {width, canvas.size.y}}, {{right, canvas.at.y}, {width, canvas.size.y}}};
}

bool beginRegion(const char* name, const Region& region, ImVec2 padding, ImGuiWindowFlags flags) {
  ImGui::SetNextWindowPos(region.at);
  ImGui::SetNextWindowSize({std::max(1.0f, region.size.x), std::max(1.0f, region.size.y)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0f);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  const bool open = ImGui::Begin(name, nullptr,
                                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav |
                                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus | flags);
  ImGui::PopStyleVar(3);
  return open;
}

void drawSplitters(const View& view, Orders& orders, const Layout& layout) {
  splitter(view, orders, "splitter.left", layout.leftSplitter, &Appearance::leftWidth, 1.0);
  splitter(view, orders, "splitter.right", layout.rightSplitter, &Appearance::rightWidth, -1.0);
  splitter(view, orders, "splitter.bottom", layout.bottomSplitter, &Appearance::bottomHeight, -1.0, false);
}

}  // namespace triscope
