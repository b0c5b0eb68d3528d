// All that a frame draws beside the menu: the fixed regions, the panels in their columns, the dialog.
#pragma once

#include "ui/app/parts.h"
#include "ui/region/layout.h"

namespace triscope {

void drawRegions(Parts& parts, const Layout& layout, Orders& orders);

}  // namespace triscope
