// The offer to restore work that an earlier run of the program left behind: beside the work, never in its way.
#include <fmt/format.h>

#include <algorithm>

#include "ui/kit/widgets.h"
#include "ui/region/regions.h"

namespace triscope {

void drawKeptOffer(const View& view, Orders& orders, ImVec2 corner, ImVec2 size) {
  const DocumentUi& document = view.ui.document;
  if (!document.offering || document.kept.empty() || view.ui.dialog != Dialog::none) return;
  const float width = std::min(view.px(440), size.x - view.px(24));
  if (beginFloating(view, "##kept", {corner.x + 0.5f * size.x, corner.y + size.y - view.px(16)}, {0.5f, 1.0f}, width)) {
    const KeptWork& work = document.kept.front();
    wrapped(fmt::format("Work on {} from {} was not saved.", work.name, work.when));
    note(view, "kept");
    const auto button = [&](const char* label, const char* name, order::Kept::What what, const char* help) {
      if (ImGui::Button(label)) orders.emplace_back(order::Kept{what});
      note(view, name);
      tip(view, help);
    };
    button("Restore", "kept.restore", order::Kept::What::restore, "Opens it as it was.");
    besideIfFits("Delete it");
    button("Delete it", "kept.discard", order::Kept::What::discard, "Deletes it for good.");
    besideIfFits("Not now");
    button("Not now", "kept.later", order::Kept::What::later,
           "Keeps it: File, Restore unsaved work brings it back, and the next start offers it again.");
  }
  endFloating();
}

}  // namespace triscope
