// What to show and how, as plain data: panels write it, files store it, buildScene() reads it.
#pragma once

#include <cstdint>
#include <string_view>

#include "core/mesh/ids.h"
#include "render/palette.h"

namespace triscope {

enum class CellColoring : std::uint8_t { none, rank, type };
enum class TriangleFill : std::uint8_t { plain, aspect, min_angle, max_angle, area_ratio, edge_ratio, density, size };
inline constexpr int kTriangleFillCount = static_cast<int>(TriangleFill::size) + 1;

/// Index in the state's arrays: vertex, triangle slot (edge: its edge 0…2), quadtree cell.
struct Selection {
  enum class Kind : std::uint8_t { none, vertex, edge, triangle, cell } kind = Kind::none;
  std::int32_t index = -1;
  std::int32_t edge = -1;  // of the triangle `index`, when kind is edge

  [[nodiscard]] Vertex vertex() const { return Vertex(index); }
  [[nodiscard]] Slot slot() const { return Slot(index); }
  [[nodiscard]] Half half() const { return Half(3 * index + edge); }
  friend bool operator==(const Selection&, const Selection&) = default;
};

/// Marks the triangles whose measure lies in [low, high] (a brushed bar of a histogram); the largest double is open
/// upwards.
struct Brush {
  bool on = false;
  TriangleFill measure = TriangleFill::aspect;
  double low = 0.0;
  double high = 0.0;
  friend bool operator==(const Brush&, const Brush&) = default;
};

struct ViewOptions {
  bool boundary = true;        // curves of the domain
  bool boundaryPoints = true;  // points on it, kept ones apart from placed ones
  bool quadtree = false;
  CellColoring cells = CellColoring::rank;
  bool outsideCells = false;  // cells outside the domain too
  bool constraints = false;   // density constraints with their source
  bool fronts = true;         // ● front 1, ◆ front 2
  bool steiner = false;       // ▲ points of steps 1-5
  bool degrees = false;       // vertices with fewer or more triangles than their angle asks for
  bool triangulation = true;
  bool helpers = true;  // triangles outside the domain, before carve
  TriangleFill fill = TriangleFill::plain;
  bool obtuse = false;   // highlight
  bool worst = true;     // the three circles of Figure 4
  bool decision = true;  // the current decision
  bool labels = true;    // texts in the picture
  bool dimmed = false;   // everything pale: an old mesh while a new one is made
  Selection selection;
  Brush brush;
  ThemeKind theme = ThemeKind::light;
  Scale scale = Scale::cividis;
  friend bool operator==(const ViewOptions&, const ViewOptions&) = default;
};

std::string_view name(TriangleFill fill);  // "aspect ratio"
std::string_view name(CellType type);      // "adjacent boundary"

}  // namespace triscope
