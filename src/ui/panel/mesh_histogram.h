// How a measure is spread over the triangles of the current mesh; a click on a bar, or a drag over some, marks their
// triangles.
#pragma once

#include "ui/model/view.h"

namespace triscope {

void drawMeshHistogram(const View& view, Orders& orders);

}  // namespace triscope
