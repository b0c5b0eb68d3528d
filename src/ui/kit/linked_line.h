// Text with links, broken into lines where the panel ends.
#pragma once

#include <string_view>

#include "core/words/links.h"
#include "ui/model/view.h"

namespace triscope {

/// Draws the line across the width that is left; a link that is clicked is followed. `name` is what tests call its
/// links by: "name.triangle 7".
void drawLine(const View& view, Orders& orders, const Line& line, std::string_view name);

}  // namespace triscope
