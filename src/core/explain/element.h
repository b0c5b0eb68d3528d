// The figures of one element as text: what Inspect shows, for scripts and for people who cannot see the window.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "core/mesh/centroid.h"
#include "core/method/state.h"
#include "core/quality/quality.h"
#include "core/run/element_events.h"

namespace triscope {

/// Figures of a triangle, vertex or cell as the state has it, with those around it as links; says so when it has none.
/// An event is its caption.
std::vector<Line> figuresOf(const MeshState& state, Events events, Ref ref);

/// One worst measure of a mesh, the bound it is held to, and the triangle that has it.
struct WorstMeasure {
  std::string_view name;  // "aspect ratio"
  std::string_view key;   // "aspect_ratio", as in reports
  double value;
  double bound;
  bool upper;  // the value must be below the bound; above it otherwise
  Slot slot;   // none for an empty mesh
  [[nodiscard]] bool met() const { return upper ? value < bound : value > bound; }
};
/// Aspect ratio, area ratio, edge ratio, smallest and largest angle (degrees).
std::array<WorstMeasure, 5> worstOf(const Quality& quality);

}  // namespace triscope
