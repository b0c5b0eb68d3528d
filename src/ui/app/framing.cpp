#include "ui/app/framing.h"

#include <algorithm>

namespace triscope {

void frameBox(UiState& ui, const Box& box, double marginAt100) {
  const double most = 0.06 * std::min(ui.camera.width, ui.camera.height);  // of a small canvas
  const double margin = std::min(marginAt100 * ui.scale(), most);
  ui.camera = fitted(box, ui.camera.width, ui.camera.height, margin);
  ui.fitted = false;
}

void fit(Desk& desk, double above) {
  Camera& camera = desk.ui.camera;
  const Camera whole = camera;
  if (above < 0.25 * whole.height) camera.height -= above;  // unless they are too low for it
  frameBox(desk.ui, desk.scene.bounds, 24.0);
  camera.centre.y += 0.5 * (whole.height - camera.height) / camera.scale;
  camera.height = whole.height;
  desk.ui.fitted = true;
}

void zoomMiddle(Desk& desk, double factor) {
  Camera& camera = desk.ui.camera;
  camera = zoomed(camera, camera.middle(), factor, desk.scene.bounds);
  desk.ui.fitted = false;
}

void showWorst(Desk& desk, Slot slot, Slot other) {
  const Mesh& mesh = desk.shown->state.mesh;
  Box box;
  for (const Slot one : {slot, other})
    if (one.exists())
      for (const Vertex v : mesh.triangles[one].v) box.include(mesh.points[v]);
  const double reach = 3.0 * std::max(box.width(), box.height());  // with its surroundings
  box.include(box.lo - Point{reach, reach});
  box.include(box.hi + Point{reach, reach});
  frameBox(desk.ui, box);
  select(desk.ui, pickOf(mesh, slot));
}

}  // namespace triscope
