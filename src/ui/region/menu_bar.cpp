#include "ui/kit/widgets.h"
#include "ui/region/regions.h"

namespace triscope {
namespace {

/// Actions that end a group within their menu.
bool endsGroup(Action action) {
  switch (action) {
    case Action::reload:
    case Action::restore_work:
    case Action::save_figure:
    case Action::play_pause:
    case Action::round:
    case Action::to_end:
    case Action::faster:
    case Action::redo:
    case Action::continue_back:
    case Action::first_violation:
    case Action::next_mark:
    case Action::why:
    case Action::first_difference:
    case Action::compare_panel:
    case Action::zoom_out:
    case Action::worst_edge:
    case Action::next_fill:
      return true;
    default:
      return false;
  }
}

}  // namespace

void drawMenuBar(const View& view, Orders& orders) {
  for (const Menu menu : {Menu::file, Menu::edit, Menu::run, Menu::debug, Menu::compare, Menu::view, Menu::help}) {
    const std::string title(nameOf(menu));
    const bool open = ImGui::BeginMenu(title.c_str());
    note(view, "menu." + title);
    if (!open) continue;
    for (const ActionInfo& info : actions()) {
      if (info.menu != menu || info.scope != Scope::window) continue;
      actionEntry(view, orders, info.id, std::string(info.label).c_str(), std::string("menu.").append(info.key));
      if (endsGroup(info.id)) ImGui::Separator();
    }
    ImGui::EndMenu();
  }
}

}  // namespace triscope
