#include "ui/app/switches.h"

#include <algorithm>
#include <cmath>

namespace triscope {
namespace {

constexpr int kFramesToType = 5;  // until keys go elsewhere again, should the field not take them

}  // namespace

void setSpeed(Desk& desk, double decisionsPerSecond) {
  desk.ui.speed = decisionsPerSecond;
  if (desk.session.progress().activity == Activity::playing) desk.session.apply(command::Play{decisionsPerSecond});
}

void setScale(UiState& ui, double scale) { ui.look.scale = std::clamp(std::round(scale * 4.0) / 4.0, 0.75, 3.0); }

void toggleQuadtree(UiState& ui) {
  ViewOptions& o = ui.options;
  ui.layersFollow = false;
  flip(o.quadtree);
  if (o.quadtree && o.triangulation && o.fill != TriangleFill::plain)
    ui.message = "The quadtree is hidden by the coloured triangles; T or C lets it be seen.";
}

void toggleBottom(UiState& ui, Panel panel) {
  std::optional<Panel>& bottom = ui.debug.bottom;
  bottom = bottom == panel ? std::nullopt : std::optional(panel);
  ui.debug.typeSoon = bottom == Panel::breakpoints ? kFramesToType : 0;
}

void nextFill(UiState& ui) {
  TriangleFill& fill = ui.options.fill;
  fill = static_cast<TriangleFill>((static_cast<int>(fill) + 1) % kTriangleFillCount);
}

void nextTheme(UiState& ui) {
  ThemeKind& theme = ui.look.theme;
  theme = static_cast<ThemeKind>((static_cast<int>(theme) + 1) % 3);
}

}  // namespace triscope
