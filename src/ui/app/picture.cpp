#include "ui/app/picture.h"

#include <algorithm>

#include "render/figure.h"
#include "ui/app/framing.h"
#include "ui/kit/imgui_pixels.h"
#include "ui/region/regions.h"

namespace triscope {
namespace {

/// Quadtree and constraints are shown while they are made, until one of them is switched by hand.
void followStage(UiState& ui, Stage stage) {
  if (!ui.layersFollow) return;
  const ViewOptions figure = figureView(stage);
  ui.options.quadtree = figure.quadtree;
  ui.options.constraints = figure.constraints;
}

/// The place of the mouse in the world, where it is over one of the pictures.
std::optional<Point> cursorOver(const Panes& panes, const Camera& camera, bool comparing) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const Pixel pixel = mouseOn(comparing && mouse.x < panes.live.at.x ? panes.pinned.at : panes.live.at);
  const bool over = pixel.x >= 0.0 && pixel.y >= 0.0 && pixel.x < camera.width && pixel.y < camera.height;
  return over ? std::optional(toWorld(camera, pixel)) : std::nullopt;
}

void updateLiveScene(Parts& parts) {
  Desk& desk = parts.desk;
  const RunView run = runOf(desk);
  const Snapshot& now = *run.now();
  followStage(desk.ui, run.stage());
  const InsertionUi& insertion = desk.ui.insertion;
  const bool entered = run.inInsertion();
  const bool inside = entered && insertion.phase != InsertionPhase::filled;
  ViewOptions options = desk.ui.picture();
  options.dimmed = desk.session.stale();
  options.selection = run.selection();
  options.worst = options.worst && !entered;  // their circles would be taken for the insertion's
  const InsertionView shown{insertion.now.get(), insertion.phase};
  updateScene(desk.scene, now.state, options, now.last ? &*now.last : nullptr, &now.quality, inside ? &shown : nullptr);
  if (desk.ui.fitted) fit(desk, headingsAbove(parts));
}

}  // namespace

double headingsAbove(Parts& parts) {
  if (!parts.desk.ui.pinned) return 0.0;
  return static_cast<double>(paneHeadingHeight(viewOf(parts), static_cast<float>(parts.desk.ui.camera.height)));
}

void drawPicture(Parts& parts, const Region& region) {
  UiState& ui = parts.desk.ui;
  const Panes panes = panesOf(region, ui);
  const double width = std::max(1.0, static_cast<double>(panes.live.size.x));
  const double height = std::max(1.0, static_cast<double>(panes.live.size.y));
  if (ui.camera.width != width || ui.camera.height != height) ui.camera = resized(ui.camera, width, height);
  const bool has = parts.desk.session.current() != nullptr;
  if (has)
    updateLiveScene(parts);
  else
    parts.desk.scene.theme = themeOf(ui.look.theme);
  parts.renderer->draw(parts.desk.scene, ui.camera, ui.scale());
  parts.comparison.draw(ui.picture());
  ui.cursor = has ? cursorOver(panes, ui.camera, ui.pinned) : std::nullopt;
}

}  // namespace triscope
