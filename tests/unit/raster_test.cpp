#include "render/raster.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "render/coverage.h"
#include "render/sample_fill.h"
#include "render/stroke.h"
#include "sample_states.h"

namespace triscope::raster_test {
namespace {

constexpr Color kWhite{255, 255, 255, 255};
constexpr Color kBlack{0, 0, 0, 255};

// Area that black covers of a white picture, in pixels.
double inkIn(const Image& image) {
  double sum = 0.0;
  for (const Color& c : image.pixels) sum += 1.0 - c.r / 255.0;
  return sum;
}

Image painted(int size, const std::vector<std::vector<Pixel>>& polygons) {
  Image image(size, size, kWhite);
  Coverage coverage(size, size);
  for (const auto& polygon : polygons) coverage.addPolygon(polygon);
  coverage.paint(image, kBlack, 0, 0, size, size);
  return image;
}

TEST(Coverage, IsTheExactArea) {
  const Image rect = painted(20, {{{2.25, 3.5}, {7.5, 3.5}, {7.5, 9.75}, {2.25, 9.75}}});
  EXPECT_NEAR(inkIn(rect), 5.25 * 6.25, 0.1);
  EXPECT_EQ(rect.at(4, 5).r, 0);
  EXPECT_EQ(rect.at(12, 5).r, 255);
  EXPECT_NEAR(rect.at(2, 5).r, 255 * 0.25, 1.0);
  EXPECT_NEAR(rect.at(5, 3).r, 255 * 0.5, 1.0);
  EXPECT_NEAR(inkIn(painted(40, {circlePolyline({20.3, 19.8}, 15.0)})), std::numbers::pi * 225.0, 2.5);
  EXPECT_NEAR(inkIn(painted(40, {{{1, 1}, {38.5, 4.25}, {12.75, 36.5}}})), 0.5 * (37.5 * 35.5 - 3.25 * 11.75), 0.5);
}

TEST(Coverage, DoesNotDependOnTheTurn) {
  const std::vector<Pixel> one{{1, 1}, {9, 2}, {4, 8}};
  const std::vector<Pixel> other(one.rbegin(), one.rend());
  EXPECT_EQ(painted(12, {one}).pixels, painted(12, {other}).pixels);
}

TEST(Coverage, PiecesOfOnePolygonLeaveNoSeam) {
  std::vector<std::vector<Pixel>> fan;
  for (int i = 0; i < 11; ++i) {
    const auto corner = [](int k) {
      const double a = 2.0 * std::numbers::pi * k / 11.0;
      return Pixel{20.0 + 18.0 * std::cos(a), 20.0 + 18.0 * std::sin(a)};
    };
    fan.push_back({{20.2, 19.7}, corner(i), corner(i + 1)});
  }
  const Image image = painted(40, fan);
  for (int y = 10; y < 30; ++y) {
    for (int x = 10; x < 30; ++x) EXPECT_LE(image.at(x, y).r, 1) << x << ' ' << y;
  }
}

TEST(Coverage, WhatLiesOutsideIsCutOff) {
  EXPECT_NEAR(inkIn(painted(10, {{{-50, -50}, {60, -50}, {60, 60}, {-50, 60}}})), 100.0, 1e-6);
  EXPECT_NEAR(inkIn(painted(10, {{{-50, 2}, {5, 2}, {5, 4}, {-50, 4}}})), 10.0, 0.05);
  EXPECT_EQ(inkIn(painted(10, {{{11, 2}, {20, 2}, {20, 4}, {11, 4}}})), 0.0);
  EXPECT_EQ(inkIn(painted(10, {{{2, -9}, {5, -9}, {5, -4}}})), 0.0);
}

TEST(SampleFill, NeighboursOfTwoColoursLeaveNoBackground) {
  Image image(30, 30, kWhite);
  const std::vector<Pixel> points{{2, 2}, {28, 3}, {27, 28}, {3, 26}, {13.3, 17.1}};
  const std::vector<Index3> triangles{{{0, 1, 4}}, {{1, 2, 4}}, {{2, 3, 4}}, {{3, 0, 4}}};
  const std::vector<Color> fills{{200, 0, 0, 255}, {0, 0, 200, 255}, {200, 0, 0, 255}, {0, 0, 200, 255}};
  fillTriangles(image, {0, 0, 30, 30}, points, triangles, fills, false);
  for (int y = 6; y < 24; ++y) {
    for (int x = 6; x < 24; ++x) EXPECT_EQ(image.at(x, y).g, 0) << x << ' ' << y;
  }
  EXPECT_EQ(image.at(0, 0), kWhite);
}

TEST(SampleFill, TranslucentNeighboursAreNotDrawnTwice) {
  Image image(20, 20, kWhite);
  const std::vector<Pixel> points{{1, 1}, {19, 1}, {19, 19}, {1, 19}};
  const std::vector<Index3> triangles{{{0, 1, 2}}, {{0, 2, 3}}};
  const std::vector<Color> fills{{0, 0, 0, 128}};
  fillTriangles(image, {0, 0, 20, 20}, points, triangles, fills, false);
  for (int i = 2; i < 18; ++i) {
    for (int k = 2; k < 18; ++k) EXPECT_EQ(image.at(i, k), image.at(10, 3));
  }
}

TEST(SampleFill, KeepsInsideItsClip) {
  Image image(20, 20, kWhite);
  const std::vector<Pixel> points{{-100, -100}, {200, -100}, {50, 300}};
  const std::vector<Index3> triangles{{{0, 1, 2}}};
  const std::vector<Color> fills{kBlack};
  fillTriangles(image, {5, 6, 9, 12}, points, triangles, fills, false);
  EXPECT_NEAR(inkIn(image), 4.0 * 6.0, 1e-9);
}

TEST(Stroke, DashesCoverTheirShare) {
  const std::vector<Pixel> line{{0, 0}, {70, 0}, {70, 70}, {0, 70}};
  const Paths dashes = dashed(line, patternOf(Dash::dashed), 1.0);
  double on = 0.0;
  for (std::size_t i = 0; i < dashes.starts.size(); ++i) {
    const auto piece = dashes.path(i);
    for (std::size_t k = 0; k + 1 < piece.size(); ++k) on += distance(piece[k], piece[k + 1]);
  }
  EXPECT_NEAR(on, 210.0 * 0.6, 1e-9) << "6 on, 4 off, round the corners";
  EXPECT_EQ(dashes.starts.size(), 21u);
}

TEST(Font, KnowsTheSignsOfTheMethod) {
  for (const char* sign : {"≈", "≥", "ω", "θ", "Δ", "●", "◆", "°", "√", "∠", "✓", "–", "é"}) {
    EXPECT_GT(textWidth(sign, 20.0), 3.0) << sign;
    EXPECT_NE(textContours(sign, {}, 20.0).size(), 0u) << sign;
    EXPECT_NE(textContours(sign, {}, 20.0).front(), textContours("\U0010FFFD", {}, 20.0).front()) << sign;
  }
  EXPECT_GT(textWidth("semibold", 20.0, Weight::semibold), textWidth("semibold", 20.0));
  EXPECT_NEAR(textWidth("mesh", 26.0), 2.0 * textWidth("mesh", 13.0), 1e-9);
}

TEST(Font, MalformedTextIsShownNotTrusted) {
  for (const std::string text : {"\xff\xfe", "a\xc3", "\xe2\x82", "\xf0\x9f\x98", "\x80"}) {
    EXPECT_GE(textWidth(text, 12.0), 0.0);
  }
  std::string_view cut = "\xe2(x";
  EXPECT_EQ(takeCodePoint(cut), U'\uFFFD');
  std::string_view euro = "€!";
  EXPECT_EQ(takeCodePoint(euro), U'€');
  EXPECT_EQ(euro, "!");
}

TEST(Raster, TextLeavesInkWhereItStands) {
  Image image(120, 30, kWhite);
  rasterCanvas(image)->text({10.0, 20.0}, "Delaunay", {14.0, Weight::regular, kBlack, {0, 0, 0, 0}, Anchor::left});
  EXPECT_GT(inkIn(image), 60.0);
  const double width = textWidth("Delaunay", 14.0);
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 120; ++x) {
      const bool outside = x < 9 || x > 11 + width || y < 7 || y > 25;
      EXPECT_TRUE(!outside || image.at(x, y) == kWhite) << x << ' ' << y;
    }
  }
}

TEST(Raster, LettersKeepTheirHoles) {
  Image image(40, 40, kWhite);
  const double x = 20.0 - 0.5 * textWidth("O", 36.0);
  rasterCanvas(image)->text({x, 33.0}, "O", {36.0, Weight::regular, kBlack, {0, 0, 0, 0}, Anchor::left});
  EXPECT_EQ(image.at(20, 20), kWhite);
  Image mono(40, 40, kWhite);
  rasterCanvas(mono)->text({5.0, 33.0}, "∠", {36.0, Weight::regular, kBlack, {0, 0, 0, 0}, Anchor::left});
  EXPECT_GT(inkIn(mono), 20.0);
}

TEST(Raster, ShowsTheWorldWhereTheCameraSaysItIs) {
  const MeshState state = sample::after(sample::kFrame, Stage::density);
  ViewOptions view;
  view.quadtree = true;
  view.cells = CellColoring::type;
  view.boundary = view.boundaryPoints = false;
  const Scene scene = buildScene(state, view, nullptr, nullptr);
  const PictureOptions options;
  const PictureLayout layout = layoutWithin(700, 500, 1.0, scene, options);
  const Camera camera = fitted(scene.bounds, layout.plot.width, layout.plot.height, 4.0);
  const Image image = rasterize(scene, camera, layout, options);
  ASSERT_EQ(image.width, 700);
  ASSERT_EQ(image.height, 500);
  int seen = 0;
  for (const Cell& cell : state.tree.cells) {
    if (cell.child >= 0 || cell.type == CellType::outside) continue;
    const Point middle = state.tree.corner(cell) + (0.5 * state.tree.side(cell)) * Point{1.0, 1.0};
    const Pixel p = toPixel(camera, middle);
    if (p.x < 2 || p.y < 2 || p.x > camera.width - 2 || p.y > camera.height - 2) continue;
    const Color expected = cellTypeColor(scene.theme, cell.type);
    EXPECT_EQ(image.at(static_cast<int>(layout.plot.x + p.x), static_cast<int>(layout.plot.y + p.y)), expected);
    ++seen;
  }
  EXPECT_GT(seen, 10);
}

TEST(Raster, MarksLieOnTheirPoints) {
  for (const Shape shape : {Shape::circle, Shape::diamond, Shape::square, Shape::triangle, Shape::cross}) {
    Image image(40, 40, kWhite);
    const PlacedMark mark{{20.0, 20.0}, 12.0f};
    rasterCanvas(image)->marks({&mark, 1}, shape, kBlack, {0, 0, 0, 0});
    EXPECT_LT(image.at(20, 20).r, 40);
    for (int i = 0; i < 40; ++i) {
      EXPECT_EQ(image.at(i, 11), kWhite);
      EXPECT_EQ(image.at(11, i), kWhite);
    }
  }
  Image ring(40, 40, kWhite);
  const PlacedMark mark{{20.0, 20.0}, 12.0f};
  rasterCanvas(ring)->marks({&mark, 1}, Shape::ring, kBlack, {0, 0, 0, 0});
  EXPECT_EQ(ring.at(20, 20), kWhite);
  EXPECT_GT(inkIn(ring), 20.0);
}

TEST(Png, SaysItsSizeAndRefusesTheImpossible) {
  const Result<std::string> png = encodePng(Image(300, 7, kWhite));
  ASSERT_TRUE(png.ok());
  EXPECT_EQ(png->substr(1, 3), "PNG");
  EXPECT_EQ(static_cast<unsigned char>((*png)[18]), 1);  // 300 = 256 + 44
  EXPECT_EQ(static_cast<unsigned char>((*png)[19]), 44);
  EXPECT_EQ(static_cast<unsigned char>((*png)[23]), 7);
  EXPECT_FALSE(encodePng(Image()).ok());
}

TEST(Blend, KeepsTheEndsExact) {
  EXPECT_EQ(blend(kWhite, kBlack, 1.0f), kBlack);
  EXPECT_EQ(blend(kWhite, kBlack, 0.0f), kWhite);
  EXPECT_EQ(blend({10, 20, 30, 255}, {10, 20, 30, 90}, 0.5f), (Color{10, 20, 30, 255}));
  EXPECT_EQ(blend({0, 0, 0, 0}, {10, 20, 30, 255}, 0.5f).a, 128);
}

}  // namespace
}  // namespace triscope::raster_test
