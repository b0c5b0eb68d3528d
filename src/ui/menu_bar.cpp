#include "ui/panels.h"
#include "ui/widgets.h"

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

void item(const View& view, Orders& orders, const ActionInfo& info) {
  const std::string reason = whyNot(info.id, view);
  const std::string label(info.label);
  const std::string keys = info.chords[0].key == 0 ? std::string() : textOf(info.chords[0]);
  if (ImGui::MenuItem(label.c_str(), keys.c_str(), isOn(info.id, view.ui).value_or(false), reason.empty()))
    orders.emplace_back(info.id);
  note(view, std::string("menu.").append(info.key), reason.empty());
  tip(view, reason.empty() ? std::string(info.help) : std::string(info.help) + "\nNot now: " + reason);
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
      item(view, orders, info);
      if (endsGroup(info.id)) ImGui::Separator();
    }
    ImGui::EndMenu();
  }
}

}  // namespace triscope
