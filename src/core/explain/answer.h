// The common tongue of Why, Why not and History: lines of text made from recorded events. Used by these alone.
#pragma once

#include <string>
#include <vector>

#include "core/explain/why.h"

namespace triscope {

/// "Event 1204: Step 3 put vertex 611 …"
std::string told(Events events, std::size_t index);

/// What is to be said of an element that no event made.
std::string withoutBirth(Events events, Ref ref);

/// "It ended with event 1300: …"
std::string ending(Events events, std::size_t death);

/// The last event before `end` that says why the element is as it is: a cell's last ranking, or else its birth.
std::optional<std::size_t> reasonFor(Events events, Ref ref, std::size_t end);

/// The event that the decision of event `index` followed from.
std::optional<std::size_t> causeOf(Events events, std::size_t index);

/// Lines as they are said.
class Answer {
 public:
  explicit Answer(Events events) : events_(events) {}

  /// Nothing is said of an empty text.
  void say(const std::string& text);
  /// The event, what it followed from, and so on, `causes` events in all at most. An event is told once.
  void tell(std::size_t index, std::size_t causes);
  std::vector<Line> take() { return std::move(lines_); }

 private:
  Events events_;
  std::vector<Line> lines_;
  std::vector<std::size_t> told_;
};

}  // namespace triscope
