#include <filesystem>

#include "ui/dialog/dialogs.h"
#include "ui/kit/path_field.h"
#include "ui/kit/widgets.h"
#include "ui/model/export_format.h"

namespace triscope {

void ExportDialog::draw(const View& view, Orders& orders) {
  if (!beginDialog(view, "Export", 520)) return;
  muted(view, "Format");
  const ExportFormat* const now = exportFormatOf(path_);
  for (const ExportFormat& format : exportFormats()) {
    if (ImGui::RadioButton(format.extension, now == &format))
      path_ = std::filesystem::path(path_).replace_extension(format.extension).string();
    note(view, std::string("export") + format.extension);
    ImGui::SameLine(view.px(110));
    ImGui::TextDisabled("%s", format.what);
  }
  const bool entered = pathField(view, "export", path_);
  const ExportFormat* const chosen = exportFormatOf(path_);
  const bool sweep = chosen != nullptr && chosen->content == ExportFormat::Content::sweep;
  std::string reason = chosen == nullptr ? "The name must end in one of the formats above."
                       : sweep           ? infoOf(Action::save_sweep).whyNot(view)
                                         : infoOf(Action::export_mesh).whyNot(view);
  const bool pressed = writeOrClose(
      view, orders, "export", "Export", reason,
      sweep ? "Writes the sweep, with the columns of 'triscope sweep'." : "Writes the mesh as it is at this moment.");
  if ((pressed || entered) && reason.empty()) {
    orders.emplace_back(order::CloseDialog{});
    orders.emplace_back(order::ExportTo{path_});
  }
  ImGui::EndPopup();
}

}  // namespace triscope
