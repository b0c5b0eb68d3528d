#include <fmt/format.h>

#include <cctype>

#include "core/pipeline.h"
#include "render/number.h"
#include "ui/panels.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace triscope {
namespace {

constexpr double kIndent = 22.0;  // pixels at 100 %, of the texts beside the dot

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

/// As much of a text as fits in a width, with an ellipsis where it was cut.
std::string fitted(const ImFont& font, const std::string& text, float width) {
  const auto wide = [&font](const std::string& t) {
    return font.CalcTextSizeA(font.FontSize, 1e6f, 0.0f, t.c_str()).x;
  };
  if (wide(text) <= width) return text;
  std::string cut = text;
  while (!cut.empty()) {
    const std::size_t space = cut.rfind(' ');
    cut.erase(space == std::string::npos ? 0 : space);
    if (std::string shown = cut + " \xE2\x80\xA6"; wide(shown) <= width) return shown;
  }
  return "\xE2\x80\xA6";
}

/// What is drawn over one row: a dot, the name, the counts, and what the stage does.
void paint(const View& view, const StageInfo& info, const MeshState* state, ImVec2 at, float width) {
  const bool current = state != nullptr && state->stage == info.id;
  const StageCounts counts = state != nullptr ? state->counts[static_cast<std::size_t>(info.id)] : StageCounts{};
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
  const ImU32 mutedColor = toImU32(view.theme().textMuted);
  list.AddText(&font, font.FontSize, {at.x + indent, at.y}, toImU32(view.theme().text), std::string(info.name).c_str());
  const std::string tally = countsOf(counts);
  const float wide = small.CalcTextSizeA(small.FontSize, 1e6f, 0.0f, tally.c_str()).x;
  list.AddText(&small, small.FontSize, {at.x + width - wide, at.y + view.px(1)}, mutedColor, tally.c_str());
  const std::string does(info.does);
  const std::string shown = current ? does : fitted(small, does, width - indent);
  list.AddText(&small, small.FontSize, {at.x + indent, at.y + line}, mutedColor, shown.c_str(), nullptr,
               current ? width - indent : 0.0f);
}

void row(const View& view, Orders& orders, const StageInfo& info, const MeshState* state) {
  const bool current = state != nullptr && state->stage == info.id;
  const std::string name(info.name);
  const std::string does(info.does);
  const float width = ImGui::GetContentRegionAvail().x;
  const ImFont& small = *view.fonts.small;
  const float wrap = current ? width - view.px(kIndent) : 0.0f;
  const float below = small.CalcTextSizeA(small.FontSize, 1e6f, wrap, does.c_str()).y;
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
  note(view, "stage." + std::string(info.key));
  std::string hint = std::string(does) + ".";
  hint[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(hint[0])));
  if (!info.figure.empty()) hint += " " + std::string(info.figure) + " of the paper.";
  if (state != nullptr && state->counts[static_cast<std::size_t>(info.id)].decisions > 0)
    hint += "\n" + countsInWords(state->counts[static_cast<std::size_t>(info.id)]);
  tip(view, hint + "\nClick to go to where it begins.");
  // The current stage is brought into view when it has changed, and not when the list is scrolled by hand.
  ImGuiStorage& memory = *ImGui::GetStateStorage();
  const ImGuiID shown = ImGui::GetID("current stage");
  if (current && memory.GetInt(shown, -1) != static_cast<int>(info.id)) {
    memory.SetInt(shown, static_cast<int>(info.id));
    ImGui::SetScrollHereY(0.5f);
  }
  paint(view, info, state, at, width);
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
