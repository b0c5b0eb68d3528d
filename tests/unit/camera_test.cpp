#include "render/camera.h"

#include <gtest/gtest.h>

#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

namespace triscope::camera_test {
namespace {

Box boxOf(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y1}}; }

TEST(Camera, PixelsRunDownAndComeBack) {
  const Camera camera{{3.0, -2.0}, 40.0, 800.0, 600.0};
  EXPECT_EQ(toPixel(camera, {3.0, -2.0}), (Pixel(400.0, 300.0)));
  EXPECT_EQ(toPixel(camera, {4.0, -1.0}), (Pixel(440.0, 260.0)));
  const Point back = toWorld(camera, toPixel(camera, {3.7, 11.1}));
  EXPECT_NEAR(back.x, 3.7, 1e-12);
  EXPECT_NEAR(back.y, 11.1, 1e-12);
}

TEST(Camera, FittedShowsTheWholeBoxWithItsMargin) {
  for (const Box& box : {boxOf(-32, -32, 32, 32), boxOf(0, 0, 100, 1), boxOf(4e7, 4e7, 4e7 + 1e-3, 4e7 + 5e-3)}) {
    const Camera camera = fitted(box, 900.0, 500.0, 20.0);
    // Far from the origin a unit in the last place is a good part of a thousandth of a pixel.
    const Pixel low = toPixel(camera, box.lo);
    const Pixel high = toPixel(camera, box.hi);
    EXPECT_GE(low.x, 20.0 - 2e-3);
    EXPECT_LE(high.x, 880.0 + 2e-3);
    EXPECT_GE(high.y, 20.0 - 2e-3);
    EXPECT_LE(low.y, 480.0 + 2e-3);
    const double slack = std::min(low.x - 20.0, high.y - 20.0);
    EXPECT_LT(slack, 2e-3) << "one direction is used to the full";
  }
}

TEST(Camera, FittedCopesWithBoxesWithoutExtent) {
  EXPECT_GT(fitted(Box{}, 100.0, 100.0, 5.0).scale, 0.0);
  const Camera point = fitted(boxOf(5, 5, 5, 5), 100.0, 100.0, 5.0);
  EXPECT_EQ(point.centre, (Point{5.0, 5.0}));
  EXPECT_TRUE(std::isfinite(point.scale) && point.scale > 0.0);
  EXPECT_TRUE(std::isfinite(fitted(boxOf(0, 1, 7, 1), 100.0, 100.0, 5.0).scale));
  EXPECT_GT(fitted(boxOf(0, 0, 1, 1), 0.0, 0.0, 50.0).scale, 0.0);
}

TEST(Camera, ClipCoordinatesAreThePicturesCorners) {
  Camera camera{{3.0, -2.0}, 40.0, 800.0, 600.0};
  const Point origin{1.0, 1.0};
  const glm::dmat3x2 clip = clipFrom(camera, origin);
  for (const Pixel corner : {Pixel(0, 0), Pixel(800, 0), Pixel(800, 600), Pixel(0, 600), Pixel(400, 300)}) {
    const Point place = toWorld(camera, corner) - origin;
    const glm::dvec2 at = clip * glm::dvec3(place.x, place.y, 1.0);
    EXPECT_NEAR(at.x, corner.x / 400.0 - 1.0, 1e-12);
    EXPECT_NEAR(at.y, 1.0 - corner.y / 300.0, 1e-12);
  }
}

TEST(Camera, ZoomKeepsThePointUnderTheCursor) {
  const Box box = boxOf(-32, -32, 32, 32);
  Camera camera = fitted(box, 800.0, 600.0, 10.0);
  const Pixel cursor{123.0, 456.0};
  for (const double factor : {1.25, 3.0, 0.1, 7.7}) {
    const Point before = toWorld(camera, cursor);
    camera = zoomed(camera, cursor, factor, box);
    const Point after = toWorld(camera, cursor);
    EXPECT_NEAR(before.x, after.x, 1e-9);
    EXPECT_NEAR(before.y, after.y, 1e-9);
  }
}

TEST(Camera, ZoomStopsWhereDoublesNoLongerResolveAPixel) {
  const Box box = boxOf(4e7, 4e7, 4e7 + 10, 4e7 + 10);
  Camera camera = fitted(box, 800.0, 600.0, 10.0);
  for (int i = 0; i < 200; ++i) camera = zoomed(camera, {400.0, 300.0}, 2.0, box);
  EXPECT_LT(4e7 * 2.3e-16, 1.0 / camera.scale) << "a pixel is wider than a unit in the last place";
  for (int i = 0; i < 400; ++i) camera = zoomed(camera, {400.0, 300.0}, 0.5, box);
  EXPECT_GT(camera.scale * box.width(), 10.0) << "the domain never becomes a speck";
}

TEST(Camera, PanMovesByPixels) {
  const Camera camera{{0.0, 0.0}, 10.0, 100.0, 100.0};
  const Camera moved = panned(camera, {30.0, -20.0});
  EXPECT_EQ(toPixel(moved, {0.0, 0.0}), (Pixel(80.0, 30.0)));
}

TEST(Camera, VisibleBoxIsWhatTheCornersShow) {
  const Camera camera{{1.0, 2.0}, 4.0, 80.0, 40.0};
  const Box box = visibleBox(camera);
  EXPECT_EQ(box.lo, toWorld(camera, {0.0, 40.0}));
  EXPECT_EQ(box.hi, toWorld(camera, {80.0, 0.0}));
}

}  // namespace
}  // namespace triscope::camera_test
