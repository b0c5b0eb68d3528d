// The theme's colours and sizes as Dear ImGui wants them.
#pragma once

#include <imgui.h>

#include "render/palette.h"

namespace triscope {

/// Sets colours and, for a content scale, sizes of the current context.
void applyStyle(const Theme& theme, float scale);

inline ImU32 toImU32(Color c) { return IM_COL32(c.r, c.g, c.b, c.a); }
inline ImVec4 toImVec4(Color c) { return ImGui::ColorConvertU32ToFloat4(toImU32(c)); }
/// The colour that marks what is chosen or active in this theme; text on it takes onAccent().
Color accentOf(const Theme& theme);
Color onAccent(const Theme& theme);

}  // namespace triscope
