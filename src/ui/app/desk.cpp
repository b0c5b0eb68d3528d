#include "ui/app/desk.h"

namespace triscope {
namespace {

// A step that takes longer than this is shown when it is done; until then the window goes on.
constexpr std::chrono::milliseconds kPatience{40};

}  // namespace

void give(Desk& desk, const Command& command) {
  desk.session.apply(command);
  if (!std::holds_alternative<command::Play>(command)) desk.session.settle(kPatience);
}

NamedFile openDomain(const Desk& desk) {
  const Domain* const domain = shownDomain(desk);
  return {"the domain that is open", domain != nullptr ? domain->file : std::string()};
}

void select(UiState& ui, const Pick& pick) {
  ui.selected = pick;
  ui.density.request.reset();
}

void openDialog(UiState& ui, Dialog dialog) {
  ui.dialog = dialog;
  if (dialog != Dialog::error) ui.error.reset();
}

void complain(UiState& ui, const Error& error) {
  ui.error = error;
  ui.dialog = Dialog::error;
}

}  // namespace triscope
