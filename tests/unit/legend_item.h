// What the legend of a scene says.
#pragma once

#include <algorithm>
#include <string_view>

#include "render/scene.h"

namespace triscope {

/// The row with this label, null when there is none.
inline const LegendItem* legendItem(const Scene& scene, std::string_view label) {
  const auto found = std::ranges::find(scene.legend, label, &LegendItem::label);
  return found == scene.legend.end() ? nullptr : &*found;
}

}  // namespace triscope
