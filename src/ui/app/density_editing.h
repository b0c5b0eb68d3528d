// Density constraints edited with the mouse: each edit is another domain, and its mesh is made at once.
#pragma once

#include "ui/app/tuning.h"

namespace triscope {

class DensityEditing {
 public:
  DensityEditing(Desk& desk, Tuning& tuning) : desk_(desk), tuning_(tuning) {}

  /// What the domain asks of the density from now on.
  void edit(const order::EditDensity& order);
  void name(const order::NameRequest& typed);
  /// A new constraint.
  void place(Point at);
  /// The one that is selected and held; it follows the mouse.
  void move(Point to);
  /// The one that is selected.
  void remove();
  void select(const order::SelectRequest& order);
  void togglePlacing();
  /// Lets go of a selection that is of another domain, or was taken back.
  void follow();
  void letGo() { desk_.ui.density.held = false; }
  /// Another document.
  void forget() { desk_.ui.density = {}; }

 private:
  Desk& desk_;
  Tuning& tuning_;
};

}  // namespace triscope
