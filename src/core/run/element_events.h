// Which recorded events are about an element. Nothing is computed again: only events are read.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/run/events.h"
#include "core/words/event.h"
#include "core/words/links.h"

namespace triscope {

/// True when the event made the element.
bool made(const Event& event, Ref ref);
/// True when the event made the element, was proposed for it, judged it, changed it or ended it.
bool isAbout(const Event& event, Ref ref);

/// False when no event among those can be about the element.
bool mayBeAbout(const Mentioned& events, Ref ref);

/// The event that made the element. Ids are given out in order, so this is a binary search. Nothing for what no
/// decision made (the box around everything, the root cell) and for what is not made yet.
std::optional<std::size_t> birthOf(Events events, Ref ref);

/// Every event about the element, ascending. An event is about itself.
std::vector<std::size_t> eventsAbout(Events events, Ref ref);

}  // namespace triscope
