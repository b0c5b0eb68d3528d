#include "ui/kit/widgets.h"

#include <imgui_internal.h>

#include <algorithm>

#include "ui/kit/style.h"
#include "ui/kit/wrapped_text.h"

namespace triscope {

void note(const View& view, std::string_view name, bool enabled) {
  if (view.widgets == nullptr) return;
  const ImVec2 lo = ImGui::GetItemRectMin();
  const ImVec2 hi = ImGui::GetItemRectMax();
  if (hi.x > lo.x && hi.y > lo.y && lo.x + hi.x > 0.0f) view.widgets->push_back({std::string(name), lo, hi, enabled});
}

namespace {

void tooltip(const View& view, const std::string& text) {
  if (view.tooltip != nullptr) *view.tooltip = text;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(view.px(340));
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  if (view.widgets != nullptr) {
    const ImVec2 lo = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    view.widgets->push_back({"tooltip", lo, {lo.x + size.x, lo.y + size.y}, true});
  }
  ImGui::EndTooltip();
}

bool wantsTip(const View& view, const std::string& text) {
  return !text.empty() && !view.ui.tipsWait && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled);
}

}  // namespace

void tip(const View& view, const std::string& text) {
  if (wantsTip(view, text)) tooltip(view, text);
}

void tipAbove(const View& view, const std::string& text) {
  if (!wantsTip(view, text)) return;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  // As far over to the right as the mouse is across the window: so it never leaves it.
  const float across = mouse.x / ImGui::GetIO().DisplaySize.x;
  ImGui::SetNextWindowPos({mouse.x, ImGui::GetItemRectMin().y - view.px(4)}, ImGuiCond_Always, {across, 1.0f});
  tooltip(view, text);
}

namespace {

constexpr double kLowWindow = 380.0;  // pixels at 100 %

std::string tooltipOf(const ActionInfo& info, const std::string& reason) {
  std::string text(info.help);
  if (const std::string keys = keysOf(info); !keys.empty()) text += "\nKeys: " + keys;
  if (!reason.empty()) text += "\nNot now: " + reason;
  return text;
}

}  // namespace

bool inLowWindow(const View& view) { return ImGui::GetIO().DisplaySize.y < view.px(kLowWindow); }

float iconButtonWidth(const View& view) { return ImGui::GetFrameHeight() * (inLowWindow(view) ? 1.0f : 1.25f); }

void actionButton(const View& view, Orders& orders, Action action, Icon icon) {
  const ActionInfo& info = infoOf(action);
  const std::string reason = infoOf(action).whyNot(view);
  const std::string name(info.key);
  ImGui::PushID(name.c_str());
  ImGui::BeginDisabled(!reason.empty());
  bool pressed = false;
  if (icon == Icon::none) {
    pressed = ImGui::Button(std::string(info.label).c_str());
  } else {
    const float side = ImGui::GetFrameHeight();
    pressed = ImGui::Button("##icon", {iconButtonWidth(view), side});
    const ImVec2 lo = ImGui::GetItemRectMin();
    const ImVec2 hi = ImGui::GetItemRectMax();
    drawIcon(*ImGui::GetWindowDrawList(), icon, {0.5f * (lo.x + hi.x), 0.5f * (lo.y + hi.y)}, side * 0.56f,
             ImGui::GetColorU32(ImGuiCol_Text));
  }
  ImGui::EndDisabled();
  ImGui::PopID();
  note(view, name, reason.empty());
  tip(view, tooltipOf(info, reason));
  if (pressed) orders.emplace_back(action);
}

void actionButton(const View& view, Orders& orders, Action action, const char* label, std::string_view name) {
  const std::string reason = infoOf(action).whyNot(view);
  ImGui::BeginDisabled(!reason.empty());
  if (ImGui::Button(label)) orders.emplace_back(action);
  ImGui::EndDisabled();
  note(view, name, reason.empty());
  tip(view, tooltipOf(infoOf(action), reason));
}

void actionEntry(const View& view, Orders& orders, Action action, const char* label, std::string_view name) {
  const ActionInfo& info = infoOf(action);
  const std::string reason = infoOf(action).whyNot(view);
  const std::string keys = info.chords[0].key == 0 ? std::string() : textOf(info.chords[0]);
  if (ImGui::MenuItem(label, keys.c_str(), isOn(action, view.ui), reason.empty())) orders.emplace_back(action);
  note(view, name, reason.empty());
  tip(view, reason.empty() ? std::string(info.help) : std::string(info.help) + "\nNot now: " + reason);
}

void actionSwitch(const View& view, Orders& orders, Action action, const char* label) {
  const ActionInfo& info = infoOf(action);
  const std::string reason = infoOf(action).whyNot(view);
  bool on = isOn(action, view.ui);
  ImGui::BeginDisabled(!reason.empty());
  if (ImGui::Checkbox(label, &on)) orders.emplace_back(action);
  ImGui::EndDisabled();
  note(view, std::string("layer.").append(info.key), reason.empty());
  tip(view, tooltipOf(info, reason));
}

void besideIfFits(const char* label) {
  ImGui::SameLine();
  const float width = ImGui::CalcTextSize(label).x + 2.0f * ImGui::GetStyle().FramePadding.x;
  if (width > ImGui::GetContentRegionAvail().x) ImGui::NewLine();
}

void figure(const View& view, const char* label, const std::string& value) {
  figure(view, label, value, view.theme().text);
}

void figure(const View& view, const char* label, const std::string& value, Color valueColor) {
  const float from = ImGui::GetCursorPosX();
  muted(view, label);
  const float width = ImGui::CalcTextSize(value.c_str()).x;
  const float right = ImGui::GetContentRegionMax().x - width;
  // Beside the label where there is room, else on a line of its own.
  if (from + ImGui::CalcTextSize(label).x + view.px(8) <= right)
    ImGui::SameLine(right);
  else
    ImGui::SetCursorPosX(std::max(ImGui::GetCursorPosX(), right));
  ImGui::PushStyleColor(ImGuiCol_Text, toImU32(valueColor));
  ImGui::TextUnformatted(value.c_str());
  ImGui::PopStyleColor();
}

void heading(const View& view, const char* text) {
  ImGui::Dummy({0, view.px(2)});
  ImGui::PushFont(view.fonts.strong);
  ImGui::TextUnformatted(text);
  ImGui::PopFont();
}

void wrapped(const std::string& text) {
  ImGui::TextUnformatted(inLines(text, ImGui::GetContentRegionAvail().x).c_str());
}

void muted(const View& view, const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, toImU32(view.theme().textMuted));
  wrapped(text);
  ImGui::PopStyleColor();
}

void title(const View& view, const std::string& text, std::string_view name) {
  ImGui::PushFont(view.fonts.title);
  wrapped(text);
  ImGui::PopFont();
  note(view, name);
}

bool link(const View& view, const std::string& text) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const bool pressed = ImGui::InvisibleButton(text.c_str(), {std::max(size.x, 1.0f), size.y});
  const bool hovered = ImGui::IsItemHovered();
  const ImU32 color = toImU32(accentOf(view.theme()));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddText(at, color, text.c_str());
  if (hovered) {
    list.AddLine({at.x, at.y + size.y}, {at.x + size.x, at.y + size.y}, color, view.px(1));
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  }
  return pressed;
}

bool menuOpen() { return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel); }

void closeMenus() {
  if (menuOpen()) ImGui::ClosePopupToLevel(0, true);
}

bool beginFloating(const View& view, const char* name, ImVec2 at, ImVec2 pivot, float width) {
  ImGui::SetNextWindowPos(at, ImGuiCond_Always, pivot);
  ImGui::SetNextWindowSize({width, 0.0f});
  constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                                      ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                                      ImGuiWindowFlags_NoNav;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, view.px(8));
  return ImGui::Begin(name, nullptr, kFlags);
}

void endFloating() {
  ImGui::End();
  ImGui::PopStyleVar();
}

namespace {

constexpr double kAroundDialog = 24.0;  // pixels at 100 %: what is seen of the window beside a dialog, on both sides
constexpr double kDialogPadding = 14.0;

}  // namespace

float dialogRoom(const View& view) {
  const float frame = ImGui::GetFrameHeight() + 2.0f * view.px(kDialogPadding) + 2.0f;  // title, padding, border
  return std::max(0.0f, ImGui::GetIO().DisplaySize.y - view.px(kAroundDialog) - frame);
}

bool beginDialog(const View& view, const char* title, double width) {
  if (!ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float wide = std::min(view.px(width), screen.x - view.px(kAroundDialog));
  ImGui::SetNextWindowPos({0.5f * screen.x, 0.5f * screen.y}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSizeConstraints({wide, 0.0f}, {wide, screen.y - view.px(kAroundDialog)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {view.px(16), view.px(kDialogPadding)});
  const bool open = ImGui::BeginPopupModal(
      title, nullptr, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
  ImGui::PopStyleVar();
  return open;
}

}  // namespace triscope
