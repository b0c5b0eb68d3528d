#include <array>
#include <filesystem>

#include "ui/dialogs.h"
#include "ui/path_field.h"
#include "ui/widgets.h"

namespace triscope {
namespace {

struct Format {
  const char* extension;
  const char* what;
};
constexpr const char* kTable = ".csv";
constexpr std::array<Format, 10> kFormats{{
    {".msh", "Gmsh 4.1, boundary edges as named groups"},
    {".vtu", "VTK, with the quality of each triangle"},
    {".su2", "SU2, with markers"},
    {".node", "Triangle's .node, .ele and .poly"},
    {".off", "Object File Format"},
    {".obj", "Wavefront"},
    {".json", "the domain, with its density constraints"},
    {".svg", "picture of what is in view, as vectors"},
    {".png", "picture of what is in view, as pixels"},
    {kTable, "the sweep over \xCF\x89 and \xCE\xB8, a line for each pair"},
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
  const bool entered = pathField(view, "export", path_);
  const Format* const chosen = formatOf(path_);
  const bool table = chosen != nullptr && chosen->extension == kTable;
  std::string reason = chosen == nullptr ? "The name must end in one of the formats above."
                       : table           ? whyNot(Action::save_sweep, view)
                                         : whyNot(Action::export_mesh, view);
  const bool pressed = writeOrClose(
      view, orders, "export", "Export", reason,
      table ? "Writes the sweep, with the columns of 'triscope sweep'." : "Writes the mesh as it is at this moment.");
  if ((pressed || entered) && reason.empty()) {
    orders.emplace_back(order::CloseDialog{});
    orders.emplace_back(order::ExportTo{path_});
  }
  ImGui::EndPopup();
}

}  // namespace triscope
