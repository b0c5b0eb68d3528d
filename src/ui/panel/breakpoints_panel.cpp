// The breakpoints, what was met so far, and what can be written.
#include <fmt/format.h>
#include <imgui.h>
// Needs imgui.h before it.
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>

#include "core/base/number.h"
#include "ui/kit/style.h"
#include "ui/kit/widgets.h"
#include "ui/panel/panels.h"

namespace triscope {
namespace {

constexpr const char* kActionHelp = "Stop there, or only list and mark it on the timeline in passing (log, mark).";

bool chooseAction(const View& view, Breakpoint::Action& action, const std::string& name) {
  int chosen = static_cast<int>(action);
  ImGui::SetNextItemWidth(view.px(84));
  const bool changed =
      ImGui::Combo("##action", &chosen, kBreakpointActions.data(), static_cast<int>(kBreakpointActions.size()));
  note(view, name);
  tip(view, kActionHelp);
  action = static_cast<Breakpoint::Action>(chosen);
  return changed;
}

/// The words of the language; a click adds one to what is typed.
void words(const View& view, Orders& orders) {
  if (ImGui::Button("Words")) ImGui::OpenPopup("words");
  note(view, "break.words");
  tip(view, "What a condition can ask about.");
  ImGui::SetNextWindowSizeConstraints({0, 0}, {view.px(560), view.px(320)});
  if (!ImGui::BeginPopup("words")) return;
  for (const Word& word : conditionWords()) {
    const std::string name(word.name);
    if (ImGui::Selectable(name.c_str())) {
      std::string text = view.ui.debug.condition;
      if (!text.empty() && text.back() != ' ') text += ' ';
      orders.emplace_back(order::TypeCondition{text + name + ' ', view.ui.debug.action});
    }
    ImGui::SameLine(view.px(150));
    ImGui::TextDisabled("%s", std::string(word.help).c_str());
  }
  ImGui::EndPopup();
}

/// What is wrong with what was typed, with a mark under the character it is about. The letters are not all of one
/// width: the mark of the message, which counts characters, is put where the character is.
void complain(const View& view, const Error& error) {
  const std::string_view message = error.message;
  const std::size_t caret = message.rfind("^\n");
  const std::size_t marks = caret == std::string_view::npos ? caret : message.rfind('\n', caret);
  const std::size_t quote = marks == std::string_view::npos || marks == 0 ? marks : message.rfind('\n', marks - 1);
  ImGui::PushStyleColor(ImGuiCol_Text, toImU32(view.theme().worstAspect));
  if (quote == std::string_view::npos) {
    wrapped(error.message);
  } else {
    const std::string quoted(message.substr(quote + 1, marks - quote - 1));
    const std::string expected = "^ " + std::string(message.substr(caret + 2));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0f, 0.0f});
    ImGui::TextUnformatted(quoted.c_str());
    const float x = ImGui::CalcTextSize(quoted.substr(0, caret - marks - 1).c_str()).x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + x);
    wrapped(expected);
    ImGui::PopStyleVar();
    note(view, "break.caret");
  }
  ImGui::PopStyleColor();
}

/// An example of a condition, the longest that a field of this width can show whole.
const char* exampleWithin(float width) {
  for (const char* const example : {"aspect > 4 and stage == refine", "stage == refine", "aspect > 4"})
    if (ImGui::CalcTextSize(example).x + 2.0f * ImGui::GetStyle().FramePadding.x <= width) return example;
  return "";
}

void typed(const View& view, Orders& orders) {
  const DebugUi& debug = view.ui.debug;
  order::TypeCondition edit{debug.condition, debug.action};
  const float add = ImGui::CalcTextSize("Add").x + ImGui::CalcTextSize("Words").x +
                    4.0f * ImGui::GetStyle().FramePadding.x + view.px(84) + 3.0f * ImGui::GetStyle().ItemSpacing.x;
  const float room = ImGui::GetContentRegionAvail().x;
  const bool oneRow = room - add >= view.px(120);
  const float width = oneRow ? room - add : room;
  ImGui::SetNextItemWidth(width);
  if (debug.typeSoon > 0) {
    ImGui::SetWindowFocus();
    ImGui::SetKeyboardFocusHere();
  }
  const bool entered =
      ImGui::InputTextWithHint("##condition", exampleWithin(width), &edit.text, ImGuiInputTextFlags_EnterReturnsTrue);
  note(view, "break.condition");
  if (entered && !edit.text.empty() && !Condition::compile(edit.text)) ImGui::SetKeyboardFocusHere(-1);  // to mend it
  if (!ImGui::IsItemActive())
    tip(view, "A condition: words are compared with numbers or names, and joined by and, or, not. Enter adds it.");
  if (oneRow) ImGui::SameLine();
  const bool chosen = chooseAction(view, edit.action, "break.action");
  ImGui::SameLine();
  const bool empty = edit.text.empty();
  ImGui::BeginDisabled(empty);
  const bool pressed = ImGui::Button("Add");
  ImGui::EndDisabled();
  note(view, "break.add", !empty);
  tip(view, empty ? "Not now: type a condition first." : "Adds this breakpoint.");
  ImGui::SameLine();
  words(view, orders);
  if (edit.text != debug.condition || chosen) orders.emplace_back(edit);
  if ((entered && !empty) || pressed) orders.emplace_back(order::AddBreakpoint{});
  if (debug.complaint) complain(view, *debug.complaint);
}

void list(const View& view, Orders& orders) {
  const std::vector<Breakpoint>& all = view.session.breakpoints();
  if (all.empty()) muted(view, "No breakpoint yet. Type a condition, or select an element and press F9.");
  for (std::size_t k = 0; k < all.size(); ++k) {
    std::vector<Breakpoint> changed = all;
    bool change = false;
    ImGui::PushID(static_cast<int>(k));
    change |= ImGui::Checkbox("##enabled", &changed[k].enabled);
    note(view, fmt::format("break.{}.enabled", k));
    tip(view, "Off: passed by as if it were not there.");
    ImGui::SameLine();
    change |= chooseAction(view, changed[k].action, fmt::format("break.{}.action", k));
    ImGui::SameLine();
    const auto met = std::count_if(view.session.hits().begin(), view.session.hits().end(),
                                   [&](const PassedHit& hit) { return hit.condition == all[k].condition.text(); });
    if (ImGui::Button("Delete")) {
      changed.erase(changed.begin() + static_cast<std::ptrdiff_t>(k));
      change = true;
    }
    note(view, fmt::format("break.{}.delete", k));
    tip(view, "Takes this breakpoint away.");
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    const std::string times = met > 0 ? "   met " + counted(static_cast<std::uint64_t>(met), "time", "times") : "";
    wrapped(all[k].condition.text() + times);
    ImGui::PopID();
    if (change) orders.emplace_back(command::SetBreakpoints{std::move(changed)});
  }
}

void hits(const View& view, Orders& orders) {
  const std::vector<PassedHit>& all = view.session.hits();
  heading(view, all.empty() ? "Nothing met yet" : fmt::format("Met so far: {}", grouped(all.size())).c_str());
  if (all.empty()) muted(view, "Continue (F5, Shift+F5) lists here where breakpoints were met.");
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(all.size()));
  while (clipper.Step()) {
    for (int k = clipper.DisplayStart; k < clipper.DisplayEnd; ++k) {
      const PassedHit& hit = all[static_cast<std::size_t>(k)];
      const bool here = view.now() != nullptr && view.now()->state.tick == hit.tick;
      ImGui::PushID(k);
      if (ImGui::Selectable(fmt::format("{}  {}", grouped(hit.tick), hit.condition).c_str(), here))
        orders.emplace_back(command::Seek{hit.tick});
      ImGui::PopID();
      note(view, fmt::format("break.hit.{}", k));
    }
  }
  clipper.End();
}

}  // namespace

void drawBreakpoints(const View& view, Orders& orders) {
  const float width = ImGui::GetContentRegionAvail().x;
  const float side = std::min(view.px(340), 0.4f * width);
  if (ImGui::BeginChild("list", {width - side - view.px(12), 0.0f})) {
    typed(view, orders);
    actionButton(view, orders, Action::continue_back, Icon::none);
    for (const Action action : {Action::continue_forward, Action::first_violation}) {
      besideIfFits(std::string(infoOf(action).label).c_str());
      actionButton(view, orders, action, Icon::none);
    }
    list(view, orders);
  }
  ImGui::EndChild();
  ImGui::SameLine(0.0f, view.px(12));
  if (ImGui::BeginChild("hits", {0.0f, 0.0f})) hits(view, orders);
  ImGui::EndChild();
}

}  // namespace triscope
