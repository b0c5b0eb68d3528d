#include "ui/dialog/dialogs.h"
#include "ui/kit/path_field.h"
#include "ui/kit/widgets.h"

namespace triscope {

void SaveDialog::draw(const View& view, Orders& orders) {
  if (!beginDialog(view, "Save session", 520)) return;
  muted(view,
        "A session holds the domain, the parameters, breakpoints, bookmarks and notes, the place in the run and in the "
        "picture, and what each stage must come to.");
  const bool entered = pathField(view, "save", path_);
  const std::string reason = path_.empty() ? "Type a name first." : infoOf(Action::save_session).whyNot(view);
  const bool pressed =
      writeOrClose(view, orders, "save", "Save", reason, "Writes the session; 'triscope replay' checks it.");
  if ((pressed || entered) && reason.empty()) {
    orders.emplace_back(order::CloseDialog{});
    orders.emplace_back(order::SaveTo{path_});
  }
  ImGui::EndPopup();
}

}  // namespace triscope
