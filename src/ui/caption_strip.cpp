// The sentence under the picture: what just happened, and why.
#include <fmt/format.h>

#include "core/caption.h"
#include "core/pipeline.h"
#include "render/number.h"
#include "ui/panels.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace triscope {

std::string captionNow(const View& view) {
  const Snapshot* const now = view.now();
  if (now == nullptr) return "Open a domain to begin.";
  if (view.session.stale())
    return "A new mesh is being made; the old one is shown until it is ready. Esc keeps the old one.";
  if (now->state.stage == Stage::finished || now->state.failed || !now->last)
    return summaryOf(now->state, now->quality);
  return captionOf(*now->last);
}

void drawCaption(const View& view, Orders&) {
  const Snapshot* const now = view.now();
  if (now != nullptr) {
    const StageInfo& info =
        infoOf(now->last && now->state.stage != Stage::finished ? now->last->stage : now->state.stage);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddCircleFilled({at.x + view.px(6), at.y + 0.55f * ImGui::GetTextLineHeight()},
                                                view.px(5), toImU32(stageColor(view.theme(), info.id)));
    ImGui::Indent(view.px(20));
    ImGui::PushFont(view.fonts.strong);
    std::string title(info.name);
    if (now->state.round > 0 && info.id >= Stage::step2 && info.id <= Stage::step5)
      title += fmt::format(", round {}", now->state.round);
    if (now->state.round > 0 && info.id == Stage::refine) title += fmt::format(", pass {}", now->state.round);
    ImGui::TextUnformatted(title.c_str());
    ImGui::PopFont();
    ImGui::SameLine();
    ImGui::TextDisabled("decision %s", grouped(now->state.tick).c_str());
    const std::string figureName(info.figure);
    ImGui::SameLine(0.0f, view.px(16));
    if (ImGui::CalcTextSize(figureName.c_str()).x <= ImGui::GetContentRegionAvail().x)
      ImGui::TextDisabled("%s", figureName.c_str());
    else
      ImGui::NewLine();
  }
  const std::string caption = captionNow(view);
  ImGui::PushTextWrapPos(0.0f);
  ImGui::TextUnformatted(caption.c_str());
  ImGui::PopTextWrapPos();
  note(view, "caption");
  if (now != nullptr) ImGui::Unindent(view.px(20));
}

}  // namespace triscope
