#include "ui/app/keyboard.h"

#include <GLFW/glfw3.h>

#include <utility>

namespace triscope {
namespace {

// Dear ImGui says some frames after the key which ends the typing that text is no longer wanted.
constexpr int kFramesOfTypingsEnd = 4;

}  // namespace

void Keyboard::press(int key, int mods, std::optional<Action> mapped) {
  if (!isModifier(key)) {
    ++desk_.ui.keysPressed;
    desk_.ui.tipsWait = true;
  }
  const bool endsTyping = key == GLFW_KEY_ESCAPE || key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER;
  if (endsTyping && ImGui::GetIO().WantTextInput) typingEnds_ = kFramesOfTypingsEnd;
  const std::optional<Action> action = mapped ? mapped : actionFor(key, mods);
  if (!action) return;
  // While text is typed, keys without Ctrl and those that edit text are not commands; Esc and F1 … F25 always are.
  const bool edits = !withCtrl(mods) || *action == Action::undo || *action == Action::redo;
  pressed_.push_back({*action, edits && !isFunctionKey(key) && *action != Action::cancel});
}

std::vector<Action> Keyboard::take() {
  std::vector<Action> actions;
  for (const auto [action, types] : std::exchange(pressed_, {}))
    if (!types || !ImGui::GetIO().WantTextInput) actions.push_back(action);
  return actions;
}

bool Keyboard::ready() const {
  if (desk_.ui.debug.typeSoon > 0) return false;
  return typingEnds_ == 0 || !ImGui::GetIO().WantTextInput;
}

}  // namespace triscope
