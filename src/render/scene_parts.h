// The parts that updateScene() is made of, one per layer. Each fills an empty layer.
#pragma once

#include "render/scene.h"

namespace triscope::detail {

/// What every part needs to know.
struct SceneInput {
  const MeshState& state;
  const ViewOptions& options;
  const Theme& theme;
  std::uint64_t domainHash = 0;
  const Event* current = nullptr;
  const Quality* quality = nullptr;
  const InsertionView* insertion = nullptr;
  bool once = false;  // a picture of its own, and not a scene that is brought up to date
};

/// Ranks in use among the leaves that are shown, for the colour scale.
struct RankRange {
  int lowest = 1;
  int highest = 1;
};
RankRange rankRange(const Quadtree& tree);
/// Before cells are classified every leaf says `outside`; then they are all drawn alike.
bool classified(const Quadtree& tree);

/// Coloured triangles would cover the cells but for slivers along the boundary: then none are drawn.
bool drawsCells(const SceneInput& in);

void buildCells(const SceneInput& in, Layer& layer);
void buildMesh(const SceneInput& in, Layer& layer);
/// Brings the layer of another moment, which looked the same otherwise, up to date in the few places that differ, and
/// notes them. False when they are not few: then nothing has been done.
bool patchMesh(const SceneInput& in, Layer& layer);
void buildBoundary(const SceneInput& in, Layer& layer);
void buildPoints(const SceneInput& in, Layer& layer);
/// The vertices of a front that are still in the mesh: those that are drawn and counted.
std::vector<Vertex> frontInMesh(const Mesh& mesh, const std::vector<Vertex>& front);
void buildFronts(const SceneInput& in, Layer& layer);
void buildDegrees(const SceneInput& in, Layer& layer);
/// Vertices of fewer triangles than equilateral ones would give them have this mark; those of more have another.
inline constexpr Shape kFewer = Shape::triangle;
/// Typical distance to the neighbours of a vertex, from the density rank where it was placed.
float spacingOf(const MeshState& state, Vertex vertex);
void buildConstraints(const SceneInput& in, Layer& layer);
void buildDecision(const SceneInput& in, Layer& layer);
void buildInsertion(const SceneInput& in, Layer& layer);
void buildWorst(const SceneInput& in, Layer& layer);
void buildSelection(const SceneInput& in, Layer& layer);
/// Of a scene whose layers are up to date: what takes a look at the whole mesh is counted there.
std::vector<LegendItem> buildLegend(const SceneInput& in, const Scene& scene);

/// How a source of density is drawn: the same in the picture and in the legend.
struct SourceStyle {
  Rule source;
  Shape shape;
  Color color;
  const char* label;
};
std::vector<SourceStyle> sourceStyles(const Theme& theme);

/// Styles of the three circles of Figure 4.
LineStyle worstStyle(const Theme& theme, int which);  // 0 aspect, 1 area ratio, 2 edge ratio

/// Whether what an insertion measured is the circumradius of its candidate.
bool measuresCircumcircle(const Insertion& insertion);
/// What the phases of an insertion are drawn with, and the legend's entries of them: the boundary edge to be split,
/// what was measured, its limit, the walk, the circumcircles of the cavity's triangles, and its rim.
LineStyle splitLine(const Theme& theme);
LineStyle measuredLine(const Theme& theme);
LineStyle limitCircle(const Theme& theme);
LineStyle walkLine(const Theme& theme);
LineStyle cavityCircle(const Theme& theme);
LineStyle rimLine(const Theme& theme);

/// The measure that a fill shows: its value for every slot (dead slots: 0), and the ends of its colour scale.
/// `good` is the value of the equilateral triangle (or a uniform mesh), `bound` the paper's limit, or where what is
/// `beyond` needs to be seen.
struct MeasureScale {
  double good = 0.0;
  double bound = 0.0;
  std::string_view unit{};
  std::string_view beyond = "beyond the bound";
};
MeasureScale scaleOf(TriangleFill fill);
float measureSlot(const MeshState& state, Slot slot, TriangleFill fill);
Color measureColor(const ViewOptions& options, const Theme& theme, double value);

}  // namespace triscope::detail
