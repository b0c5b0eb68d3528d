// What the debugger's orders and actions do: breakpoints, bookmarks, searches, links, and the answers that are shown.
#pragma once

#include "ui/app/desk.h"

namespace triscope {

class Debugging {
 public:
  explicit Debugging(Desk& desk) : desk_(desk) {}

  /// A command that looks for something is on its way: what is found comes into view.
  void expectFound() { searching_ = true; }
  /// On what is selected; again takes it away.
  void toggleBreakpoint();
  /// What was typed.
  void addBreakpoint();
  void type(const order::TypeCondition& typed);
  void toggleBookmark();
  void goToMarkBefore();
  void goToMarkAfter();
  /// Selects an element, or goes to an event.
  void follow(Ref ref);
  /// To be called when there is something new to show.
  void keepInRange();
  /// Once a search is over, where it has ended comes into view, as large as the picture is now.
  void showFound();
  /// Brings up to date what the panels that are open ask.
  void updateAnswers();
  /// Another document.
  void forget();
  [[nodiscard]] const DebugAnswers& answers() const { return answers_; }

 private:
  Desk& desk_;
  DebugAnswers answers_;
  bool searching_ = false;
};

}  // namespace triscope
