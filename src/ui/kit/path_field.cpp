#include "ui/kit/path_field.h"

#include <imgui.h>
// After imgui.h, which it needs.
#include <imgui_stdlib.h>

#include <filesystem>

#include "ui/kit/widgets.h"

namespace triscope {

bool pathField(const View& view, const char* name, std::string& path) {
  ImGui::Dummy({0, view.px(4)});
  muted(view, "File");
  ImGui::SetNextItemWidth(-1.0f);
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  const bool entered = ImGui::InputText("##path", &path, ImGuiInputTextFlags_EnterReturnsTrue);
  note(view, std::string(name) + ".path");
  std::error_code failure;
  if (std::filesystem::exists(path, failure)) muted(view, "This file exists and will be replaced.");
  return entered;
}

bool writeOrClose(const View& view, Orders& orders, const char* name, const char* verb, const std::string& reason,
                  const char* help) {
  ImGui::BeginDisabled(!reason.empty());
  const bool pressed = ImGui::Button(verb, {view.px(110), 0.0f});
  ImGui::EndDisabled();
  note(view, std::string(name) + ".ok", reason.empty());
  tip(view, reason.empty() ? help : reason);
  ImGui::SameLine();
  if (ImGui::Button("Close", {view.px(110), 0.0f})) orders.emplace_back(order::CloseDialog{});
  note(view, std::string(name) + ".close");
  return pressed;
}

}  // namespace triscope
