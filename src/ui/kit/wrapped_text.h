// Text in lines that are as wide as there is room, in the current font.
#pragma once

#include <string>

namespace triscope {

/// The text with line breaks in the place of spaces, no line wider than `width` pixels. Dear ImGui would also break a
/// number at its dot. A word that is wider than a line is broken anywhere.
std::string inLines(const std::string& text, float width);

/// The first `most` (at least one) of these lines; where there are more, the last one shown ends in "…".
std::string inLines(const std::string& text, float width, int most);

}  // namespace triscope
