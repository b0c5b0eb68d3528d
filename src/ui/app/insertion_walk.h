// Stepping through one insertion. The state before it and the one after are the session's, as everywhere: the phases
// are what takeApart() finds in the one before. The camera goes near where that is needed, and back afterwards.
#pragma once

#include "ui/app/desk.h"

namespace triscope {

class InsertionWalk {
 public:
  explicit InsertionWalk(Desk& desk) : desk_(desk) {}

  /// To the next phase, or into the next insertion.
  void stepInto();
  /// To the phase before, or into the insertion before.
  void stepBack();
  /// Looks where the session has come to: on the way to an insertion it goes on.
  void follow();
  /// Out of the insertion; the camera goes back to where it was.
  void leave();
  /// What was on its way is not waited for.
  void giveUpEntering() { entering_ = {}; }
  /// Another document: nothing of it is left.
  void forget();

 private:
  /// On the way to an insertion that is to be stepped through: first to the state after it, then to the one before.
  struct Entering {
    enum class Step : std::uint8_t { none, after, before } step = Step::none;
    InsertionPhase phase = InsertionPhase::candidate;  // to be shown then
    std::size_t vertices = 0;                          // when it began
    std::uint64_t events = 0;                          // of the state after
  };
  /// The camera has gone near an insertion that is stepped through.
  struct Near {
    Camera before;
    bool fitted = false;  // it showed the whole domain then
    Camera camera;        // where it went
    /// Whether `now` is still there: the window's size may have changed.
    [[nodiscard]] bool isAt(const Camera& now) const {
      return now.centre == camera.centre && now.scale == camera.scale;
    }
  };

  void enter(InsertionPhase phase);
  void takeApartHere();
  void showPhase(InsertionPhase phase);
  void goNear(const Insertion& insertion);

  Desk& desk_;
  Entering entering_;
  std::optional<Near> near_;
};

}  // namespace triscope
