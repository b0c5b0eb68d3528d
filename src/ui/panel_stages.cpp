#include <fmt/format.h>

#include "core/pipeline.h"
#include "render/number.h"
#include "ui/panels.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace triscope {
namespace {

/// "+123  ✗4  →56": inserted, refused, moved.
std::string countsOf(const StageCounts& c) {
  std::string text;
  const auto add = [&text](const char* sign, std::uint64_t n) {
    if (n == 0) return;
    if (!text.empty()) text += "  ";
    text += sign + grouped(n);
  };
  add("+", c.inserted);
  add("\xE2\x88\x92", c.removed);
  add("\xE2\x86\x92", c.moved);
  add("\xE2\x9C\x97", c.refused);
  if (text.empty() && c.decisions > 0) text = grouped(c.decisions);
  return text;
}

std::string countsInWords(const StageCounts& c) {
  return fmt::format("{} decisions: {} inserted, {} removed, {} moved, {} refused", grouped(c.decisions),
                     grouped(c.inserted), grouped(c.removed), grouped(c.moved), grouped(c.refused));
}

void row(const View& view, Orders& orders, const StageInfo& info, const MeshState* state) {
  const bool current = state != nullptr && state->stage == info.id;
  const std::string name(info.name);
  const std::string does(info.does);
  const float indent = view.px(22);
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::PushFont(view.fonts.small);
  const float textHeight = ImGui::CalcTextSize(does.c_str(), nullptr, false, width - indent).y;
  ImGui::PopFont();
  const float height = ImGui::GetTextLineHeight() + textHeight + view.px(4);

  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::PushID(name.c_str());
  if (ImGui::Selectable("##row", current, ImGuiSelectableFlags_None, {0.0f, height})) {
    if (info.id == Stage::finished)
      orders.emplace_back(command::Advance{Grain::all});
    else
      orders.emplace_back(command::GoTo{info.id});
  }
  ImGui::PopID();
  note(view, "stage." + std::string(info.key));
  const StageCounts* const counts = state != nullptr ? &state->counts[static_cast<std::size_t>(info.id)] : nullptr;
  std::string hint = "Click to go to where it begins.";
  if (!info.figure.empty()) hint = std::string(info.figure) + " of the paper. " + hint;
  if (counts != nullptr && counts->decisions > 0) hint = countsInWords(*counts) + "\n" + hint;
  tip(view, hint);

  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float line = ImGui::GetTextLineHeight();
  const ImVec2 dot{at.x + view.px(9), at.y + 0.5f * line + view.px(1)};
  const ImU32 color = toImU32(stageColor(view.theme(), info.id));
  const bool reached = state != nullptr && (info.id < state->stage || (counts != nullptr && counts->decisions > 0));
  if (reached || current)
    list.AddCircleFilled(dot, view.px(5), color);
  else
    list.AddCircle(dot, view.px(5), color, 0, view.px(1.5));
  ImFont* const font = current ? view.fonts.strong : view.fonts.text;
  list.AddText(font, font->FontSize, {at.x + indent, at.y}, toImU32(view.theme().text), name.c_str());
  if (counts != nullptr) {
    const std::string text = countsOf(*counts);
    const float wide = view.fonts.small->CalcTextSizeA(view.fonts.small->FontSize, 1e6f, 0.0f, text.c_str()).x;
    list.AddText(view.fonts.small, view.fonts.small->FontSize, {at.x + width - wide, at.y + view.px(1)},
                 toImU32(view.theme().textMuted), text.c_str());
  }
  list.AddText(view.fonts.small, view.fonts.small->FontSize, {at.x + indent, at.y + line},
               toImU32(view.theme().textMuted), does.c_str(), nullptr, width - indent);
  if (current && ImGui::IsWindowAppearing()) ImGui::SetScrollHereY(0.5f);
}

}  // namespace

void drawStages(const View& view, Orders& orders) {
  const MeshState* const state = view.now() != nullptr ? &view.now()->state : nullptr;
  if (state != nullptr && state->round > 0)
    muted(view, state->stage == Stage::refine ? fmt::format("Pass {} of step 6", state->round)
                                              : fmt::format("Round {} of steps 2 to 5", state->round));
  for (const StageInfo& info : stages()) row(view, orders, info, state);
}

}  // namespace triscope
