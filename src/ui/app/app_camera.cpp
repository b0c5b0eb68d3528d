// Where the picture is looked at: framed, fitted and zoomed.
#include <algorithm>

#include "ui/app/app.h"

namespace triscope {

void App::showWorst(std::int32_t slot, std::int32_t other) {
  const Mesh& mesh = shown_->state.mesh;
  Box box;
  for (const std::int32_t one : {slot, other})
    if (one >= 0)
      for (const std::int32_t v : mesh.triangles[static_cast<std::size_t>(one)].v)
        box.include(mesh.points[static_cast<std::size_t>(v)]);
  const double reach = 3.0 * std::max(box.width(), box.height());  // with its surroundings
  box.include(box.lo - Point{reach, reach});
  box.include(box.hi + Point{reach, reach});
  frameBox(box, 0.0);
  select({{Selection::Kind::triangle, slot, -1}, mesh.ids[static_cast<std::size_t>(slot)], 0.0});
}

void App::frameBox(const Box& box, double marginAt100) {
  const double most = 0.06 * std::min(ui_.camera.width, ui_.camera.height);  // of a small canvas
  const double margin = std::min(marginAt100 * ui_.scale(), most);
  ui_.camera = fitted(box, ui_.camera.width, ui_.camera.height, margin);
  fitted_ = false;
}

void App::fit() {
  const Camera whole = ui_.camera;
  if (pinned_) {
    // Headings stand over the two pictures: as much room is left above, unless they are too low for it.
    const auto above = static_cast<double>(paneHeadingHeight(view(), static_cast<float>(whole.height)));
    if (above < 0.25 * whole.height) ui_.camera.height -= above;
  }
  frameBox(scene_.bounds, 24.0);
  ui_.camera.centre.y += 0.5 * (whole.height - ui_.camera.height) / ui_.camera.scale;
  ui_.camera.height = whole.height;
  fitted_ = true;
}

void App::zoomMiddle(double factor) {
  const Point middle{0.5 * ui_.camera.width, 0.5 * ui_.camera.height};
  ui_.camera = zoomed(ui_.camera, middle, factor, scene_.bounds);
  fitted_ = false;
}

}  // namespace triscope
