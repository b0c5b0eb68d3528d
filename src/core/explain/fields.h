// Sentences with the figures of an event: a template's {fields} filled in.
#pragma once

#include <string>
#include <string_view>

#include "core/words/event.h"

namespace triscope {

/// "Vertex {vertex} was removed: {why}." with the event's own numbers and words. A field that there is not stays as it
/// stands; isField tells.
std::string filled(std::string_view text, const Event& event);
bool isField(std::string_view name);

/// "1.98": four significant digits are what a reader can compare at a glance.
std::string shortNumber(double value);
std::string shortPlace(Point p);
/// "(0.1, 2.98765)": six digits, to find the place again.
std::string placeText(Point p);

}  // namespace triscope
