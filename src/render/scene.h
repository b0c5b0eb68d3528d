// A picture of one state, with no notion of how it is drawn: the window, the PNG and the SVG all draw this.
//
// A scene is a stack of layers, drawn in the order of LayerId. Within a layer: squares, triangles, lines, circles,
// marks, labels. Coordinates are in the world and are doubles (a renderer that wants floats subtracts Scene::origin
// first); widths and sizes are in pixels at 100 % and do not grow with zoom.
// A layer whose `version` is unchanged has the same content: keep what was uploaded for it.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/explain/insertion.h"
#include "core/method/state.h"
#include "core/quality/quality.h"
#include "core/words/event.h"
#include "render/view_options.h"

namespace triscope {

enum class LayerId : std::uint8_t {
  cells,
  mesh,
  boundary,
  points,
  fronts,
  degrees,
  constraints,
  decision,
  worst,
  selection
};
inline constexpr int kLayerCount = static_cast<int>(LayerId::selection) + 1;
/// Layers that may hold as much as the mesh; the others are small overlays.
constexpr bool isLarge(LayerId id) { return id <= LayerId::constraints; }

enum class Dash : std::uint8_t { solid, dashed, dash_dotted, dotted };
enum class Shape : std::uint8_t { circle, diamond, square, triangle, ring, cross };  // ● ◆ ■ ▲ ○ ✕
enum class Anchor : std::uint8_t { left, centre, right };                            // where the text starts

/// On and off lengths in pixels at 100 %, for a line of width 1; `count` entries are used (0: solid).
struct DashPattern {
  std::array<float, 4> lengths{};
  int count = 0;
};
DashPattern patternOf(Dash dash);

struct LineStyle {
  Color color;
  float width = 1.0f;
  Dash dash = Dash::solid;
  bool fades = false;  // multiply alpha by wireFade(length in pixels)
  friend bool operator==(const LineStyle&, const LineStyle&) = default;
};

/// Edges a few pixels long turn into shading instead of a black texture: 1 from 8 px on, 0.22 from 1.5 px down.
constexpr double wireFade(double lengthInPixels) {
  const double t = (lengthInPixels - 1.5) / 6.5;
  return t <= 0.0 ? 0.22 : t >= 1.0 ? 1.0 : 0.22 + 0.78 * t;
}

/// Axis-aligned squares with one colour each, and one outline style for all (width 0: none).
struct SquareBatch {
  struct Square {
    Point corner;  // lower left
    double side = 0.0;
    Color fill;
    friend bool operator==(const Square&, const Square&) = default;
  };
  std::vector<Square> squares;
  LineStyle outline;
  friend bool operator==(const SquareBatch&, const SquareBatch&) = default;
};

using Index3 = std::array<std::uint32_t, 3>;
using Index2 = std::array<std::uint32_t, 2>;

/// Triangles over shared points. `fills` has one colour per triangle, or one for all, or none.
/// `edges` names every edge once; they are drawn with `wire` (width 0: not drawn). In a scene that is brought up to
/// date there are none, and the mesh has a triangle for each slot: one without extent where there is nothing to draw.
struct TriangleBatch {
  std::vector<Point> points;
  std::vector<Index3> triangles;
  std::vector<Color> fills;
  std::vector<Index2> edges;
  LineStyle wire;
  bool hatched = false;  // fills are drawn as diagonal hatching in their colour
  friend bool operator==(const TriangleBatch&, const TriangleBatch&) = default;
};

/// Segments over shared points; successive segments that share a point form a polyline (dashes run on).
struct LineBatch {
  std::vector<Point> points;
  std::vector<Index2> segments;
  LineStyle style;
  friend bool operator==(const LineBatch&, const LineBatch&) = default;
};

struct Circle {
  Point centre;
  double radius = 0.0;         // world
  float minimumRadius = 0.0f;  // pixels: drawn no smaller than this, so that it can be found
  LineStyle style;
  friend bool operator==(const Circle&, const Circle&) = default;
};

struct MarkBatch {
  std::vector<Point> at;
  std::vector<float> spacing;  // world distance to the next mark or so, one per mark; empty: never shrink
  Shape shape = Shape::circle;
  float size = 6.0f;  // pixels across
  Color fill;         // line colour for ring and cross
  Color outline;      // 1 px; alpha 0: none
  friend bool operator==(const MarkBatch&, const MarkBatch&) = default;
};

/// Marks are drawn at `size`, smaller (never below 2 px) where their spacing is few pixels, so that they never touch.
constexpr float markSize(float size, double spacingInPixels) {
  const auto room = static_cast<float>(0.6 * spacingInPixels);
  return room >= size ? size : room > 2.0f ? room : 2.0f;
}

/// Drawn semibold.
struct Label {
  Point at;             // world
  float dx = 0.0f;      // pixels to the right of it
  float dy = 0.0f;      // pixels below it
  double around = 0.0;  // world: at least so far from it in both directions, where the picture is magnified
  std::string text;
  Color color;
  Color halo;  // drawn around the glyphs so that they read over lines
  float size = 13.0f;
  Anchor anchor = Anchor::left;
  friend bool operator==(const Label&, const Label&) = default;
};

/// What one version of a layer differs in from the one before, where that is little.
struct LayerChange {
  std::uint64_t since = 0;               // the version before; 0: everything may differ
  std::vector<std::uint32_t> triangles;  // of the first batch of triangles
  Box where;                             // holds them, as they were and as they are
};

struct Layer {
  std::uint64_t key = 0;      // of what it was built from; 0: never built
  std::uint64_t style = 0;    // the same but for the moment of the run
  std::uint64_t version = 0;  // of the content, from 1
  LayerChange change;
  std::vector<SquareBatch> squares;
  std::vector<TriangleBatch> triangles;
  std::vector<LineBatch> lines;
  std::vector<Circle> circles;
  std::vector<MarkBatch> marks;
  std::vector<Label> labels;
};

/// One row of the legend: a sample drawn as in the picture, a label, and a value (either may be empty).
struct LegendItem {
  enum class Sample : std::uint8_t { none, heading, line, circle, mark, fill, hatch, ramp } sample = Sample::none;
  LineStyle line;               // line, circle
  Shape shape = Shape::circle;  // mark
  Color fill;                   // mark, fill, hatch
  std::vector<Color> ramp;      // ramp: left to right
  std::string low;              // ramp: text under its ends
  std::string high;
  std::string label;
  std::string value;
};

struct Scene {
  std::array<Layer, kLayerCount> layers;
  std::vector<LegendItem> legend;
  std::size_t brushed = 0;  // triangles that are marked
  Theme theme;
  std::shared_ptr<const Domain> domain;
  std::uint64_t domainHash = 0;
  Box bounds;                  // of the domain
  Point origin;                // middle of the bounds: subtract before converting to float
  std::uint64_t versions = 0;  // of layers that there have been
  [[nodiscard]] const Layer& layer(LayerId id) const { return layers[static_cast<std::size_t>(id)]; }
};

/// One phase of an insertion that is taken apart; `state` is then the one before it.
struct InsertionView {
  const Insertion* insertion = nullptr;
  InsertionPhase phase = InsertionPhase::candidate;
};

/// Brings `scene` up to date with `state`; layers whose content is the same are left alone.
/// `current` is the decision that led to `state` (null: none shown); `quality` is measure(state.mesh), or null when
/// it is not known: then the circles and the figures of the legend are left out. With `insertion` its phase is shown
/// instead of `current`.
void updateScene(Scene& scene, const MeshState& state, const ViewOptions& options, const Event* current,
                 const Quality* quality, const InsertionView* insertion = nullptr);
/// A scene to be drawn once.
Scene buildScene(const MeshState& state, const ViewOptions& options, const Event* current, const Quality* quality);

}  // namespace triscope
