// The embedded fonts as outlines: widths to lay text out with, contours to fill.
#pragma once

#include <string_view>
#include <vector>

#include "render/pixel.h"

namespace triscope {

enum class Weight : std::uint8_t { regular, semibold };

/// Width in pixels of UTF-8 text at a size in pixels (the em).
double textWidth(std::string_view text, double size, Weight weight = Weight::regular);

/// Closed contours of the text with its baseline starting at `at`, in pixels with y down. Inner contours (holes)
/// turn the other way. Characters that no embedded font has are drawn as the font's missing-glyph box.
std::vector<std::vector<Pixel>> textContours(std::string_view text, Pixel at, double size,
                                             Weight weight = Weight::regular);

/// Next code point of UTF-8 text, removed from its front; U+FFFD for malformed bytes.
char32_t takeCodePoint(std::string_view& text);

}  // namespace triscope
