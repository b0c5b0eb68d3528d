#include <fmt/format.h>

#include <algorithm>

#include "core/base/capitalised.h"
#include "core/base/number.h"
#include "core/method/pipeline.h"
#include "ui/kit/style.h"
#include "ui/kit/widgets.h"
#include "ui/panel/panels.h"

namespace triscope {
namespace {

constexpr double kIndent = 22.0;  // pixels at 100 %, of the texts beside the dot
constexpr double kRuleAt = 62.0;  // of the rule beside a short name

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
  return fmt::format("Decisions: {}; {} inserted, {} removed, {} moved, {} refused", grouped(c.decisions),
                     grouped(c.inserted), grouped(c.removed), grouped(c.moved), grouped(c.refused));
}

/// Inside an insertion the state is the one before it, which may be of an earlier stage.
Stage currentStage(const View& view, const MeshState& state) {
  return view.inInsertion() ? view.ui.insertion.now->event.stage : state.stage;
}

/// What is drawn over one row: a dot, the name, the rule where it fits, the counts; below the current stage, what it
/// does.
void paint(const View& view, const StageInfo& info, const MeshState* state, bool current, ImVec2 at, float width) {
  const StageCounts counts = state != nullptr ? state->counts[info.id] : StageCounts{};
  const bool reached = current || counts.decisions > 0 || (state != nullptr && info.id < state->stage);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float line = ImGui::GetTextLineHeight();
  const float indent = view.px(kIndent);
  const ImVec2 dot{at.x + view.px(9), at.y + 0.5f * line + view.px(1)};
  const ImU32 color = toImU32(stageColor(view.theme(), info.id));
  if (reached)
    list.AddCircleFilled(dot, view.px(5), color);
  else
    list.AddCircle(dot, view.px(5), color, 0, view.px(1.5));
  const ImFont& font = current ? *view.fonts.strong : *view.fonts.text;
  const ImFont& small = *view.fonts.small;
  const auto wide = [](const ImFont& f, const std::string& t) {
    return f.CalcTextSizeA(f.FontSize, 1e6f, 0.0f, t.c_str()).x;
  };
  const ImU32 mutedColor = toImU32(view.theme().textMuted);
  const std::string name(info.name);
  list.AddText(&font, font.FontSize, {at.x + indent, at.y}, toImU32(view.theme().text), name.c_str());
  const std::string tally = countsOf(counts);
  const float tallyAt = at.x + width - wide(small, tally);
  list.AddText(&small, small.FontSize, {tallyAt, at.y + view.px(1)}, mutedColor, tally.c_str());
  const std::string rule(info.rule);
  const float ruleAt = at.x + indent + std::max(view.px(kRuleAt), wide(font, name) + view.px(8));
  if (ruleAt + wide(small, rule) + view.px(8) <= tallyAt)
    list.AddText(&small, small.FontSize, {ruleAt, at.y + view.px(1)}, mutedColor, rule.c_str());
  if (current)
    list.AddText(&small, small.FontSize, {at.x + indent, at.y + line}, mutedColor, std::string(info.does).c_str(),
                 nullptr, width - indent);
}

void row(const View& view, Orders& orders, const StageInfo& info, const MeshState* state) {
  const bool current = state != nullptr && currentStage(view, *state) == info.id;
  const std::string name(info.name);
  const std::string does(info.does);
  const float width = ImGui::GetContentRegionAvail().x;
  const ImFont& small = *view.fonts.small;
  const float below =
      current ? small.CalcTextSizeA(small.FontSize, 1e6f, width - view.px(kIndent), does.c_str()).y : 0.0f;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::PushID(name.c_str());
  if (ImGui::Selectable("##row", current, ImGuiSelectableFlags_None,
                        {0.0f, ImGui::GetTextLineHeight() + below + view.px(2)})) {
    if (info.id == Stage::finished)
      orders.emplace_back(command::Advance{Grain::all});
    else
      orders.emplace_back(command::GoTo{info.id});
  }
  ImGui::PopID();
  note(view, fmt::format("stage.{}", info.key));
  if (current) note(view, "current_stage");
  std::string hint = fmt::format("{}.", capitalised(does));
  if (!info.figure.empty()) hint += fmt::format(" {} of the paper.", info.figure);
  if (state != nullptr && state->counts[info.id].decisions > 0)
    hint += fmt::format("\n{}", countsInWords(state->counts[info.id]));
  tip(view, hint + "\nClick to go to where it begins.");
  // The current stage is brought into view when it or the room has changed, and not when the list is scrolled by hand.
  ImGuiStorage& memory = *ImGui::GetStateStorage();
  const ImGuiID shown = ImGui::GetID("current stage");
  const ImGuiID room = ImGui::GetID("room");
  const float height = ImGui::GetWindowHeight() / ImGui::GetTextLineHeight();
  if (current && (memory.GetInt(shown, -1) != static_cast<int>(info.id) || memory.GetFloat(room) != height)) {
    memory.SetInt(shown, static_cast<int>(info.id));
    memory.SetFloat(room, height);
    ImGui::SetScrollHereY(ImGui::GetItemRectSize().y < 0.8f * ImGui::GetWindowHeight() ? 0.5f : 0.0f);
  }
  paint(view, info, state, current, at, width);
}

}  // namespace

void drawStages(const View& view, Orders& orders) {
  const MeshState* const state = view.now() != nullptr ? &view.now()->state : nullptr;
  if (state != nullptr && view.round() > 0) muted(view, turnHeading(state->stage, view.round()));
  for (const StageInfo& info : stages()) row(view, orders, info, state);
}

}  // namespace triscope
