#include "ui/kit/plot_frame.h"

#include <algorithm>
#include <cmath>

#include "ui/kit/style.h"

namespace triscope {

PlotFrame plotFrameHere(const View& view) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float line = view.fonts.small->FontSize;
  return {
      {at.x + view.px(48), at.y + view.px(4)},
      {at.x + std::max(view.px(90), room.x - view.px(6)), at.y + std::max(view.px(30), room.y - line - view.px(4))}};
}

void plotText(const View& view, ImVec2 at, float align, const std::string& words, Color color) {
  const ImFont& font = *view.fonts.small;
  const float wide = font.CalcTextSizeA(font.FontSize, 1e6f, 0.0f, words.c_str()).x;
  ImGui::GetWindowDrawList()->AddText(&font, font.FontSize, {at.x - align * wide, at.y}, toImU32(color), words.c_str());
}

void plotGround(const View& view, const PlotFrame& f) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(f.lo, f.hi, toImU32(view.theme().background));
  list.AddRect(f.lo, f.hi, ImGui::GetColorU32(ImGuiCol_Border));
}

void plotTicks(const View& view, const PlotFrame& f, const std::vector<PlotTick>& ticks) {
  const float small = view.fonts.small->FontSize;
  float below = f.hi.y + small;  // top of what is written already
  for (const PlotTick& tick : ticks) {
    const float at = std::round(tick.at);
    if (at > f.lo.y && at < f.hi.y)
      ImGui::GetWindowDrawList()->AddLine({f.lo.x, at}, {f.hi.x, at}, ImGui::GetColorU32(ImGuiCol_Border));
    const float top = std::clamp(at - 0.5f * small, f.lo.y, std::max(f.lo.y, f.hi.y - small));
    if (top + small > below) continue;
    plotText(view, {f.lo.x - view.px(5), top}, 1.0f, tick.value, view.theme().textMuted);
    below = top;
  }
}

void dashedLine(const View& view, ImVec2 a, ImVec2 b, Color color) {
  const float length = std::hypot(b.x - a.x, b.y - a.y);
  const float dash = view.px(6);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const int dashes = static_cast<int>(std::ceil(length / (2.0f * dash)));
  for (int k = 0; k < dashes; ++k) {
    const float s = 2.0f * dash * static_cast<float>(k);
    const float e = std::min(s + dash, length);
    list.AddLine({a.x + (b.x - a.x) * s / length, a.y + (b.y - a.y) * s / length},
                 {a.x + (b.x - a.x) * e / length, a.y + (b.y - a.y) * e / length}, toImU32(color), view.px(1.5));
  }
}

}  // namespace triscope
