// Keys and typed text in the order they came, handed out in helpings that one frame can act on. Dear ImGui 1.86 looks
// at which keys are down once a frame: a key that is pressed and released between two frames was never pressed.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

namespace triscope {

/// As GLFW reports it.
struct KeyEvent {
  int key = 0;
  int scancode = 0;
  int action = 0;  // GLFW_PRESS, GLFW_REPEAT, GLFW_RELEASE
  int mods = 0;
  std::uint32_t text = 0;  // a typed character instead of a key; 0: a key
};

class KeyQueue {
 public:
  void push(const KeyEvent& event) { waiting_.push_back(event); }
  [[nodiscard]] bool empty() const { return waiting_.empty(); }
  /// The next events for one frame: a run of text, or what leads up to one key that is a command ("Return",
  /// "Ctrl+A") and that key. Nothing that came later is handed out sooner.
  std::vector<KeyEvent> take();

 private:
  std::deque<KeyEvent> waiting_;
};

}  // namespace triscope
