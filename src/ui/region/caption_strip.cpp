// The sentence under the picture: what just happened, and why.
#include <fmt/format.h>

#include <algorithm>

#include "core/base/number.h"
#include "core/explain/caption.h"
#include "core/method/pipeline.h"
#include "ui/kit/style.h"
#include "ui/kit/widgets.h"
#include "ui/kit/wrapped_text.h"
#include "ui/region/regions.h"

namespace triscope {

namespace {

float phasesWidth() { return 1.25f * ImGui::GetTextLineHeight() * static_cast<float>(kInsertionPhases); }

/// ① ② ③ ④ with the phase that is shown filled, and its name where it fits.
void phases(const View& view) {
  const InsertionPhase now = view.ui.insertion.phase;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImFont& font = *view.fonts.small;
  const float side = ImGui::GetTextLineHeight();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  for (int k = 1; k <= kInsertionPhases; ++k) {
    const bool current = k == static_cast<int>(now);
    const ImVec2 middle{at.x + (static_cast<float>(k) - 0.5f) * 1.25f * side, at.y + 0.5f * side};
    const ImU32 ink = toImU32(current ? accentOf(view.theme()) : view.theme().textMuted);
    if (current)
      list.AddCircleFilled(middle, 0.54f * side, ink);
    else
      list.AddCircle(middle, 0.54f * side, ink, 0, view.px(1));
    const std::string digit = fmt::format("{}", k);
    const ImVec2 size = font.CalcTextSizeA(font.FontSize, 1e6f, 0.0f, digit.c_str());
    list.AddText(&font, font.FontSize, {middle.x - 0.5f * size.x, middle.y - 0.5f * size.y},
                 current ? toImU32(view.theme().surface) : ink, digit.c_str());
  }
  ImGui::Dummy({phasesWidth(), side});
  note(view, "phases");
  tip(view, "The phases of one insertion: candidate, walk, cavity, new triangles.\nF11 goes on, Shift+F11 back.");
  const std::string label(name(now));
  ImGui::SameLine();
  if (ImGui::CalcTextSize(label.c_str()).x <= ImGui::GetContentRegionAvail().x)
    ImGui::TextUnformatted(label.c_str());
  else
    ImGui::NewLine();
}

/// The paper's figure of a stage, where it fits.
void figureOf(const StageInfo& info) {
  const std::string figureName(info.figure);
  if (ImGui::CalcTextSize(figureName.c_str()).x <= ImGui::GetContentRegionAvail().x)
    ImGui::TextDisabled("%s", figureName.c_str());
  else
    ImGui::NewLine();
}

}  // namespace

std::string captionNow(const View& view) {
  const Snapshot* const now = view.now();
  if (now == nullptr) return "Open a domain to begin.";
  if (view.session.stale())
    return "A new mesh is being made; the old one is shown until it is ready. Esc keeps the old one.";
  const InsertionUi& insertion = view.ui.insertion;
  if (view.inInsertion()) return insertion.captions[static_cast<std::size_t>(insertion.phase) - 1];
  if (now->state.stage == Stage::finished || now->state.failed || !now->last)
    return summaryOf(now->state, now->quality);
  if (now->last->kind == EventKind::stage_finished) return captionOf(*now->last, now->state);
  return captionOf(*now->last);
}

void drawCaption(const View& view, Orders&) {
  const Snapshot* const now = view.now();
  const bool titled = now != nullptr && ImGui::GetContentRegionAvail().y > 2.5f * ImGui::GetTextLineHeight();
  if (titled) {
    const StageInfo& info = infoOf(view.stage());
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddCircleFilled({at.x + view.px(6), at.y + 0.55f * ImGui::GetTextLineHeight()},
                                                view.px(5), toImU32(stageColor(view.theme(), info.id)));
    ImGui::Indent(view.px(20));
    ImGui::PushFont(view.fonts.strong);
    std::string title(info.name);
    title += turnBehind(info.id, view.round());
    ImGui::TextUnformatted(title.c_str());
    ImGui::PopFont();
    ImGui::SameLine();
    ImGui::TextDisabled("decision %s", grouped(now->state.tick).c_str());
    ImGui::SameLine(0.0f, view.px(16));
    if (view.inInsertion() && phasesWidth() <= ImGui::GetContentRegionAvail().x)
      phases(view);
    else
      figureOf(info);
  }
  const std::string caption = captionNow(view);
  // Whole lines only: what has no room is in the tooltip.
  const float room = ImGui::GetWindowPos().y + ImGui::GetWindowHeight() - ImGui::GetCursorScreenPos().y;
  const int lines = std::max(1, static_cast<int>(room / ImGui::GetTextLineHeight()));
  const float width = ImGui::GetContentRegionAvail().x;
  const std::string shown = inLines(caption, width, lines);
  ImGui::TextUnformatted(shown.c_str());
  note(view, "caption");
  if (shown != inLines(caption, width)) tip(view, caption);
  if (titled) ImGui::Unindent(view.px(20));
}

}  // namespace triscope
