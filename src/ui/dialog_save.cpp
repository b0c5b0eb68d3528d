#include <imgui.h>
// After imgui.h, which it needs.
#include <imgui_stdlib.h>

#include <filesystem>

#include "ui/dialogs.h"
#include "ui/widgets.h"

namespace triscope {

void SaveDialog::draw(const View& view, Orders& orders) {
  if (!beginDialog(view, "Save session", 520)) return;
  muted(view,
        "A session holds the domain, the parameters, breakpoints, bookmarks and notes, the place in the run and in the "
        "picture, and what each stage must come to.");
  ImGui::Dummy({0, view.px(4)});
  muted(view, "File");
  ImGui::SetNextItemWidth(-1.0f);
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  const bool entered = ImGui::InputText("##path", &path_, ImGuiInputTextFlags_EnterReturnsTrue);
  note(view, "save.path");
  std::error_code failure;
  if (std::filesystem::exists(path_, failure)) muted(view, "This file exists and will be replaced.");
  const std::string reason = path_.empty() ? "Type a name first." : whyNot(Action::save_session, view);
  ImGui::BeginDisabled(!reason.empty());
  const bool pressed = ImGui::Button("Save", {view.px(110), 0.0f});
  ImGui::EndDisabled();
  note(view, "save.ok", reason.empty());
  tip(view, reason.empty() ? "Writes the session; 'triscope replay' checks it." : reason);
  if ((pressed || entered) && reason.empty()) {
    orders.emplace_back(order::CloseDialog{});
    orders.emplace_back(order::SaveTo{path_});
  }
  ImGui::SameLine();
  if (ImGui::Button("Close", {view.px(110), 0.0f})) orders.emplace_back(order::CloseDialog{});
  note(view, "save.close");
  ImGui::EndPopup();
}

}  // namespace triscope
