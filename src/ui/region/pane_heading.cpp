// Which of two runs a picture shows, what sets it apart, and where it stands.
#include <fmt/format.h>

#include <algorithm>

#include "core/base/number.h"
#include "core/method/pipeline.h"
#include "core/study/compare.h"
#include "ui/kit/style.h"
#include "ui/kit/widgets.h"
#include "ui/model/pinned_run.h"
#include "ui/region/regions.h"

namespace triscope {
namespace {

constexpr double kHeadingMargin = 8.0;  // pixels at 100 %

/// "ω = 0.05, θ = 5°": the values of this run that the other has differently.
std::string apart(const View& view, bool pinned) {
  return differencesText(differences(view.pinned->session().settings(), view.session.settings()),
                         pinned ? &SettingDifference::a : &SettingDifference::b);
}

std::string standing(const Session& session) {
  const Snapshot* const now = session.current().get();
  if (now == nullptr) return "being made";
  const MeshState& state = now->state;
  std::string text(infoOf(state.stage).name);
  text += turnBehind(state.stage, state.round);
  return text + fmt::format(", decision {}", grouped(state.tick));
}

/// Whether a picture of this height has room for where its run stands.
bool hasSecondLine(const View& view, float pane) { return pane > 8.0f * view.fonts.strong->FontSize; }

}  // namespace

float paneHeadingHeight(const View& view, float pane) {
  const float second = hasSecondLine(view, pane) ? view.fonts.small->FontSize : 0.0f;
  return view.fonts.strong->FontSize + second + 2.0f * view.px(kHeadingMargin);
}

void drawPaneHeading(const View& view, Pane pane, ImVec2 corner, ImVec2 size) {
  const bool pinned = pane == Pane::pinned;
  const std::string name = pinned ? "A" : "B";
  const std::string values = apart(view, pinned);
  const std::string where = standing(pinned ? view.pinned->session() : view.session);
  const ImFont& strong = *view.fonts.strong;
  const ImFont& small = *view.fonts.small;
  const float margin = view.px(kHeadingMargin);
  const float room = size.x - 4.0f * margin;
  const auto width = [](const ImFont& font, const std::string& text) {
    return font.CalcTextSizeA(font.FontSize, 1e6f, 0.0f, text.c_str()).x;
  };
  // In a small picture the letter must do.
  const bool sameDensity = view.pinned->session().domain()->density == view.session.domain()->density;
  const std::string same = sameDensity ? "same parameters" : "other density constraints";
  std::string title = name + "  " + (values.empty() ? same : values);
  if (width(strong, title) > room) title = name;
  const bool second = width(small, where) <= room && hasSecondLine(view, size.y);
  const float wide = second ? std::max(width(strong, title), width(small, where)) : width(strong, title);
  const ImVec2 lo{corner.x + margin, corner.y + margin};
  const ImVec2 hi{lo.x + wide + 2.0f * margin, lo.y + strong.FontSize + (second ? small.FontSize : 0.0f) + margin};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(lo, hi, toImU32(faded(view.theme().surface, 0.94)), view.px(6));
  list.AddRect(lo, hi, ImGui::GetColorU32(ImGuiCol_Border), view.px(6));
  const ImVec2 at{lo.x + margin, lo.y + 0.5f * margin};
  list.AddText(&strong, strong.FontSize, at, toImU32(view.theme().text), title.c_str());
  if (second)
    list.AddText(&small, small.FontSize, {at.x, at.y + strong.FontSize}, toImU32(view.theme().textMuted),
                 where.c_str());
}

}  // namespace triscope
