// Keys, from the press to the action that they ask for.
#pragma once

#include <cstdint>
#include <vector>

#include "ui/app/desk.h"

namespace triscope {

class Keyboard {
 public:
  explicit Keyboard(Desk& desk) : desk_(desk) {}

  /// `mapped`: what the key means to the heat map, which comes first where it has the keys.
  void press(int key, int mods, std::optional<Action> mapped);
  /// What the keys pressed since the last frame ask for, and may now.
  std::vector<Action> take();
  /// False while it is not known whether the keys are still text.
  [[nodiscard]] bool ready() const;
  /// To be called at the end of each frame.
  void finishFrame() { typingEnds_ = typingEnds_ > 0 ? typingEnds_ - 1 : 0; }

 private:
  struct Pressed {
    Action action;
    bool types;  // means something else while text is typed
  };

  Desk& desk_;
  std::vector<Pressed> pressed_;
  int typingEnds_ = 0;  // within so many frames a key has ended the typing, if it does
};

}  // namespace triscope
