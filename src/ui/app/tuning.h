// Parameters and density constraints as they are changed, taken back and made again. While a control is held each
// change takes the place of the one before, and all of them are one step.
#pragma once

#include "ui/app/desk.h"
#include "ui/app/document.h"
#include "ui/app/insertion_walk.h"

namespace triscope {

class Tuning {
 public:
  Tuning(Desk& desk, Document& document, InsertionWalk& walk) : desk_(desk), document_(document), walk_(walk) {}

  /// Meshes with what is edited, as one step to take back.
  void change(const Edit& edit);
  /// Likewise, while a control is held; end() makes one step of it.
  void hold(const Edit& edit);
  void end();
  /// Brings back what was in force before a control was taken hold of; what it says until it is let go is passed over.
  void cancel();
  void undo();
  void redo();
  /// Whether a control is held.
  [[nodiscard]] bool holds() const { return held_.has_value(); }
  [[nodiscard]] bool canCancel() const { return held_ && !held_->cancelled; }
  /// A change that was given up or refused is no step to take back.
  void follow();
  /// Another document: nothing can be taken back.
  void forget();

 private:
  struct Held {
    Edit before;
    bool cancelled = false;
  };

  void remember(const Edit& before);
  void bring(const Edit& edit);

  Desk& desk_;
  Document& document_;
  InsertionWalk& walk_;
  std::optional<Held> held_;
};

}  // namespace triscope
