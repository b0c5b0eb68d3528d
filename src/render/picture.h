// Lays a scene out as a picture with title, legend, scale bar and caption, and draws it on a canvas.
#pragma once

#include <span>
#include <string>

#include "render/camera.h"
#include "render/canvas.h"

namespace triscope {

struct PictureOptions {
  std::string title;
  std::string caption;     // below, broken into lines
  bool legend = true;      // to the right of the plot
  bool scaleBar = true;    // below the plot, at its left
  bool background = true;  // fill it with the theme's background
  double scale = 1.0;      // of text, lines and marks
};

struct PictureLayout {
  double width = 0.0;
  double height = 0.0;
  Rect plot;
  Rect legend;
  std::vector<std::string> captionLines;
};

/// The layout of a picture of this size: what is left for the plot once the rest has found its place. `aspect` is
/// width / height of what will be shown: the plot is made no larger than it needs, and the whole is centred;
/// 0: the plot takes all there is.
PictureLayout layoutWithin(double width, double height, double aspect, const Scene& scene,
                           const PictureOptions& options);
/// The layout of a picture whose plot has the size of the camera.
PictureLayout layoutAround(const Camera& camera, const Scene& scene, const PictureOptions& options);

/// Draws the picture; `camera` shows the world in layout.plot.
void drawPicture(const Scene& scene, const Camera& camera, const PictureLayout& layout, const PictureOptions& options,
                 Canvas& canvas);

/// Labels of all layers where they fit: moved aside where two would overlap, left out where there is no room.
struct PlacedLabel {
  const Label* label = nullptr;
  Pixel at;  // left end of the baseline, pixels of the camera
  double width = 0.0;
};
/// `avoid`: what else stands in the picture; a label covers it only where it has no other place.
std::vector<PlacedLabel> placeLabels(const Scene& scene, const Camera& camera, double scale,
                                     std::span<const Rect> avoid = {});

}  // namespace triscope
