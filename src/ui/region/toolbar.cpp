#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "core/base/number.h"
#include "ui/kit/widgets.h"
#include "ui/region/regions.h"

namespace triscope {
namespace {

constexpr double kTight = 3.0;   // pixels at 100 %, between buttons of a group
constexpr double kApart = 19.0;  // between groups
constexpr double kSpeedWidth = 150.0;
constexpr double kToolPadding = 8.0;

struct WorstButton {
  Action action;
  const char* label;
};
constexpr std::array<WorstButton, 3> kWorst{
    {{Action::worst_aspect, "aspect"}, {Action::worst_area, "area"}, {Action::worst_edge, "edge"}}};

float iconsWidth(const View& view, int count) {
  return static_cast<float>(count) * iconButtonWidth(view) + static_cast<float>(count - 1) * view.px(kTight);
}

void speed(const View& view, Orders& orders) {
  // On a logarithmic scale: a factor of two is the same way everywhere.
  auto rate = static_cast<float>(view.ui.speed);
  ImGui::SetNextItemWidth(view.px(kSpeedWidth));
  const std::string text = fmt::format("{} per s", compact(view.ui.speed));
  if (ImGui::SliderFloat("##speed", &rate, 1.0f, 100000.0f, text.c_str(),
                         ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_NoInput | ImGuiSliderFlags_AlwaysClamp))
    orders.emplace_back(order::SetSpeed{static_cast<double>(rate)});
  note(view, "speed");
  tip(view, "How many decisions a second playing makes.\nKeys: " + keysOf(infoOf(Action::slower)) + " slower, " +
                keysOf(infoOf(Action::faster)) + " faster");
}

void transport(const View& view, Orders& orders) {
  const bool running = view.session.busy() && !view.session.stale();
  struct Button {
    Action action;
    Icon icon;
  };
  const std::array<Button, 9> row{{{Action::restart, Icon::restart},
                                   {Action::stage_back, Icon::stage_back},
                                   {Action::insertion_back, Icon::insertion_back},
                                   {Action::step_back, Icon::step_back},
                                   {Action::play_pause, running ? Icon::pause : Icon::play},
                                   {Action::step, Icon::step},
                                   {Action::insertion, Icon::insertion},
                                   {Action::stage, Icon::stage},
                                   {Action::to_end, Icon::to_end}}};
  for (const Button& button : row) {
    if (button.action != row.front().action) ImGui::SameLine(0.0f, view.px(kTight));
    actionButton(view, orders, button.action, button.icon);
  }
}

void file(const View& view, Orders& orders) {
  actionButton(view, orders, Action::open, Icon::open);
  ImGui::SameLine(0.0f, view.px(kTight));
  actionButton(view, orders, Action::reload, Icon::reload);
}

void look(const View& view, Orders& orders) {
  actionButton(view, orders, Action::fit, Icon::fit);
  ImGui::SameLine(0.0f, view.px(3 * kTight));
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Worst");
  for (const auto& [action, label] : kWorst) {
    ImGui::SameLine(0.0f, view.px(kTight));
    actionButton(view, orders, action, label, infoOf(action).key);
  }
}

float lookWidth(const View& view) {
  float width = iconButtonWidth(view) + view.px(3 * kTight) + ImGui::CalcTextSize("Worst").x;
  for (const WorstButton& button : kWorst)
    width += view.px(kTight) + ImGui::CalcTextSize(button.label).x + 2 * ImGui::GetStyle().FramePadding.x;
  return width;
}

constexpr const char* kBeside = "A | B";

void compare(const View& view, Orders& orders) {
  const bool on = view.ui.pinned;
  if (on) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetColorU32(ImGuiCol_TabActive));
  actionButton(view, orders, Action::pin_run, kBeside, infoOf(Action::pin_run).key);
  if (on) ImGui::PopStyleColor();
}

float compareWidth() { return ImGui::CalcTextSize(kBeside).x + 2 * ImGui::GetStyle().FramePadding.x; }

void picture(const View& view, Orders& orders) { actionButton(view, orders, Action::save_picture, Icon::camera); }

/// Buttons that stay together; where the window is too narrow for all groups they go on in another row.
struct Group {
  float width;
  void (*draw)(const View&, Orders&);
};
std::array<Group, 6> groupsOf(const View& view) {
  return {{{iconsWidth(view, 2), file},
           {iconsWidth(view, 9), transport},
           {view.px(kSpeedWidth), speed},
           {compareWidth(), compare},
           {lookWidth(view), look},
           {iconsWidth(view, 1), picture}}};
}

/// What has no room in the one row of a low window: a row for each group, in a menu.
void more(const View& view, Orders& orders, const std::vector<Group>& groups) {
  if (ImGui::Button("…", {iconButtonWidth(view), 0.0f})) ImGui::OpenPopup("more");
  note(view, "toolbar.more");
  tip(view, "Speed, two runs side by side, fit, the worst triangles, and a picture.");
  ImGui::SetNextWindowPos(ImGui::GetItemRectMax(), ImGuiCond_Always, {1.0f, 0.0f});
  if (!ImGui::BeginPopup("more")) return;
  const std::size_t before = orders.size();
  for (const Group& group : groups) group.draw(view, orders);
  const bool acted = std::any_of(orders.begin() + static_cast<std::ptrdiff_t>(before), orders.end(),
                                 [](const Order& order) { return std::holds_alternative<Action>(order); });
  if (acted) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

}  // namespace

float toolbarHeight(const View& view, float width) {
  const float row = ImGui::GetFrameHeight() + view.px(kToolPadding);
  if (inLowWindow(view)) return row + view.px(kToolPadding);
  float height = row + view.px(kToolPadding);
  float x = 0.0f;
  for (const Group& group : groupsOf(view)) {
    if (x > 0.0f && x + view.px(kApart) + group.width > width - view.px(20)) {
      height += row;
      x = 0.0f;
    }
    x += (x > 0.0f ? view.px(kApart) : 0.0f) + group.width;
  }
  return height;
}

void drawToolbar(const View& view, Orders& orders) {
  const bool low = inLowWindow(view);
  const float rest = low ? view.px(kApart) + iconButtonWidth(view) : 0.0f;  // for the button of what is left
  const float width = ImGui::GetContentRegionAvail().x;
  float x = 0.0f;
  std::vector<Group> left;
  for (const Group& group : groupsOf(view)) {
    if (x > 0.0f && left.empty() && x + view.px(kApart) + group.width <= width - rest) {
      ImGui::SameLine(0.0f, view.px(kApart));
      x += view.px(kApart);
    } else if (x > 0.0f && low) {
      left.push_back(group);
      continue;
    } else {
      x = 0.0f;
    }
    group.draw(view, orders);
    x += group.width;
  }
  if (left.empty()) return;
  ImGui::SameLine(0.0f, view.px(kApart));
  more(view, orders, left);
}

}  // namespace triscope
