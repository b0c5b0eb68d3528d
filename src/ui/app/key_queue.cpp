#include "ui/app/key_queue.h"

#include <GLFW/glfw3.h>

#include <algorithm>

namespace triscope {
namespace {

bool isShift(int key) { return key == GLFW_KEY_LEFT_SHIFT || key == GLFW_KEY_RIGHT_SHIFT; }

bool isModifier(const KeyEvent& e) { return e.key >= GLFW_KEY_LEFT_SHIFT && e.key <= GLFW_KEY_RIGHT_SUPER; }

/// Text, and the keys that come with it: a text field looks at the characters only.
bool isTyping(const KeyEvent& e) {
  if (e.text != 0 || isShift(e.key)) return true;
  constexpr int kCommands = GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER;
  const bool letters = e.key >= GLFW_KEY_SPACE && e.key <= GLFW_KEY_WORLD_2;
  const bool keypad = e.key >= GLFW_KEY_KP_0 && e.key <= GLFW_KEY_KP_EQUAL && e.key != GLFW_KEY_KP_ENTER;
  return (letters || keypad) && (e.mods & kCommands) == 0;
}

}  // namespace

std::vector<KeyEvent> KeyQueue::take() {
  std::vector<KeyEvent> taken;
  bool typed = false;
  while (!waiting_.empty()) {
    const KeyEvent next = waiting_.front();
    const bool typing = isTyping(next);
    const bool press = next.text == 0 && next.action == GLFW_PRESS;
    if (typed && !typing) break;
    // Down again in the frame that it came up in would look as if it had been down all the time.
    const auto cameUp = [&next](const KeyEvent& e) {
      return e.text == 0 && e.key == next.key && e.action == GLFW_RELEASE;
    };
    if (press && !typing && std::any_of(taken.begin(), taken.end(), cameUp)) break;
    taken.push_back(next);
    waiting_.pop_front();
    typed = typed || (typing && !isShift(next.key) && next.action != GLFW_RELEASE);
    if (press && !typing && !isModifier(next)) break;
  }
  return taken;
}

}  // namespace triscope
