// The embedded fonts in the sizes that the window uses, rasterised for one content scale.
#pragma once

#include <imgui.h>

namespace triscope {

struct Fonts {
  ImFont* text = nullptr;    // 17 px a line at 100 %
  ImFont* small = nullptr;   // 15 px: what explains something
  ImFont* strong = nullptr;  // 17 px, semibold: headings
  ImFont* title = nullptr;   // 21 px, semibold: what is selected
};

/// Replaces the atlas of the current context; its texture must be uploaded again.
Fonts loadFonts(float scale);

}  // namespace triscope
