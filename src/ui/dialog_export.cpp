#include <imgui.h>
// After imgui.h, which it needs.
#include <imgui_stdlib.h>

#include <array>
#include <filesystem>

#include "ui/dialogs.h"
#include "ui/widgets.h"

namespace triscope {
namespace {

struct Format {
  const char* extension;
  const char* what;
};
constexpr std::array<Format, 9> kFormats{{
    {".msh", "Gmsh 4.1, boundary edges as named groups"},
    {".vtu", "VTK, with the quality of each triangle"},
    {".su2", "SU2, with markers"},
    {".node", "Triangle's .node, .ele and .poly"},
    {".off", "Object File Format"},
    {".obj", "Wavefront"},
    {".json", "the domain, with its density constraints"},
    {".svg", "picture of what is in view, as vectors"},
    {".png", "picture of what is in view, as pixels"},
}};

const Format* formatOf(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  for (const Format& format : kFormats)
    if (extension == format.extension) return &format;
  return nullptr;
}

}  // namespace

void ExportDialog::draw(const View& view, Orders& orders) {
  if (!beginDialog(view, "Export", 520)) return;
  muted(view, "Format");
  const Format* const now = formatOf(path_);
  for (const Format& format : kFormats) {
    if (ImGui::RadioButton(format.extension, now == &format))
      path_ = std::filesystem::path(path_).replace_extension(format.extension).string();
    note(view, std::string("export") + format.extension);
    ImGui::SameLine(view.px(110));
    ImGui::TextDisabled("%s", format.what);
  }
  ImGui::Dummy({0, view.px(4)});
  muted(view, "File");
  ImGui::SetNextItemWidth(-1.0f);
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  const bool entered = ImGui::InputText("##path", &path_, ImGuiInputTextFlags_EnterReturnsTrue);
  note(view, "export.path");
  std::error_code failure;
  if (std::filesystem::exists(path_, failure)) muted(view, "This file exists and will be replaced.");
  const std::string reason =
      formatOf(path_) == nullptr ? "The name must end in one of the formats above." : whyNot(Action::export_mesh, view);
  ImGui::BeginDisabled(!reason.empty());
  const bool pressed = ImGui::Button("Export", {view.px(110), 0.0f});
  ImGui::EndDisabled();
  note(view, "export.ok", reason.empty());
  tip(view, reason.empty() ? "Writes the mesh as it is at this moment." : reason);
  if ((pressed || entered) && reason.empty()) {
    orders.emplace_back(order::CloseDialog{});
    orders.emplace_back(order::ExportTo{path_});
  }
  ImGui::SameLine();
  if (ImGui::Button("Close", {view.px(110), 0.0f})) orders.emplace_back(order::CloseDialog{});
  note(view, "export.close");
  ImGui::EndPopup();
}

}  // namespace triscope
