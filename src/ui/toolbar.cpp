#include <fmt/format.h>

#include <cmath>

#include "render/number.h"
#include "ui/panels.h"
#include "ui/widgets.h"

namespace triscope {
namespace {

void gap(const View& view) {
  ImGui::SameLine(0.0f, view.px(9));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetFrameHeight();
  ImGui::GetWindowDrawList()->AddLine({at.x, at.y + 0.15f * height}, {at.x, at.y + 0.85f * height},
                                      ImGui::GetColorU32(ImGuiCol_Separator));
  ImGui::Dummy({1.0f, height});
  ImGui::SameLine(0.0f, view.px(9));
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
    actionButton(view, orders, button.action, button.icon);
    ImGui::SameLine(0.0f, view.px(3));
  }
}

void speed(const View& view, Orders& orders) {
  // On a logarithmic scale: a factor of two is the same way everywhere.
  auto rate = static_cast<float>(view.ui.speed);
  ImGui::SetNextItemWidth(view.px(150));
  const std::string text = fmt::format("{} per s", compact(view.ui.speed));
  if (ImGui::SliderFloat("##speed", &rate, 1.0f, 100000.0f, text.c_str(),
                         ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_NoInput | ImGuiSliderFlags_AlwaysClamp))
    orders.emplace_back(order::SetSpeed{static_cast<double>(rate)});
  note(view, "speed");
  tip(view, "How many decisions a second playing makes.\nKeys: " + keysOf(infoOf(Action::slower)) + " slower, " +
                keysOf(infoOf(Action::faster)) + " faster");
}

}  // namespace

void drawToolbar(const View& view, Orders& orders) {
  actionButton(view, orders, Action::open, Icon::open);
  ImGui::SameLine(0.0f, view.px(3));
  actionButton(view, orders, Action::reload, Icon::reload);
  gap(view);
  transport(view, orders);
  speed(view, orders);
  gap(view);
  actionButton(view, orders, Action::fit, Icon::fit);
  ImGui::SameLine(0.0f, view.px(9));
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Worst");
  for (const auto& [action, label] : {std::pair{Action::worst_aspect, "aspect"}, std::pair{Action::worst_area, "area"},
                                      std::pair{Action::worst_edge, "edge"}}) {
    ImGui::SameLine(0.0f, view.px(4));
    const std::string reason = whyNot(action, view);
    const ActionInfo& info = infoOf(action);
    ImGui::BeginDisabled(!reason.empty());
    if (ImGui::Button(label)) orders.emplace_back(action);
    ImGui::EndDisabled();
    note(view, info.key, reason.empty());
    tip(view, std::string(info.help) + "\nKeys: " + keysOf(info) + (reason.empty() ? "" : "\nNot now: " + reason));
  }
  gap(view);
  actionButton(view, orders, Action::save_picture, Icon::camera);
}

}  // namespace triscope
