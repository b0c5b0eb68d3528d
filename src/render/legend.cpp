// The legend as data: what the picture's colours, marks and lines mean, with the figures that belong to them.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "core/base/number.h"
#include "core/quality/bound_figure.h"
#include "render/boundary_points.h"
#include "render/scene_parts.h"

namespace triscope {

std::string_view name(CellType type) {
  switch (type) {
    case CellType::outside:
      return "outside";
    case CellType::boundary:
      return "boundary";
    case CellType::adjacent_boundary:
      return "adjacent boundary";
    case CellType::white:
      return "white (interior)";
  }
  return "";
}

namespace detail {
namespace {

using Sample = LegendItem::Sample;

LegendItem item(Sample sample, std::string label, std::string value = {}) {
  LegendItem result;
  result.sample = sample;
  result.label = std::move(label);
  result.value = std::move(value);
  return result;
}

LegendItem mark(Shape shape, Color fill, std::string label, std::size_t count) {
  LegendItem result = item(Sample::mark, std::move(label), grouped(count));
  result.shape = shape;
  result.fill = fill;
  return result;
}

LegendItem fillItem(Color fill, std::string label, std::string value = {}) {
  LegendItem result = item(Sample::fill, std::move(label), std::move(value));
  result.fill = fill;
  return result;
}

LegendItem lineItem(Sample sample, LineStyle line, std::string label, std::string value = {}) {
  LegendItem result = item(sample, std::move(label), std::move(value));
  result.line = line;
  return result;
}

LegendItem rankRamp(const SceneInput& in) {
  const RankRange range = rankRange(in.state.tree);
  LegendItem ramp = item(Sample::ramp, "density rank");
  const int steps = std::clamp(range.highest - range.lowest + 1, 1, 24);
  for (int i = 0; i < steps; ++i) {
    const int rank = steps == 1 ? range.lowest : range.lowest + (range.highest - range.lowest) * i / (steps - 1);
    ramp.ramp.push_back(rankColor(in.options.scale, in.theme, rank, range.lowest, range.highest));
  }
  ramp.low = fmt::format("{} (h = {})", range.lowest, compact(edgeLengthOf(in.state.tree, range.lowest)));
  ramp.high = fmt::format("{} ({})", range.highest, compact(edgeLengthOf(in.state.tree, range.highest)));
  return ramp;
}

void addCells(const SceneInput& in, std::vector<LegendItem>& legend) {
  const ViewOptions& o = in.options;
  if (!drawsCells(in) || o.cells == CellColoring::none) return;
  if (o.cells == CellColoring::rank) {
    legend.push_back(rankRamp(in));
    return;
  }
  if (!classified(in.state.tree)) return;
  legend.push_back(item(Sample::heading, "quadtree cells"));
  for (const CellType type : {CellType::boundary, CellType::adjacent_boundary, CellType::white, CellType::outside}) {
    if (type == CellType::outside && !o.outsideCells) continue;
    const auto count = std::count_if(in.state.tree.cells.begin(), in.state.tree.cells.end(),
                                     [type](const Cell& c) { return c.child < 0 && c.type == type; });
    legend.push_back(
        fillItem(cellTypeColor(in.theme, type), std::string(name(type)), grouped(static_cast<std::uint64_t>(count))));
  }
}

void addConstraints(const SceneInput& in, std::vector<LegendItem>& legend) {
  if (!in.options.constraints || in.state.constraints.empty()) return;
  legend.push_back(item(Sample::heading, "density constraints"));
  for (const SourceStyle& style : sourceStyles(in.theme)) {
    const auto count = std::count_if(in.state.constraints.begin(), in.state.constraints.end(),
                                     [&style](const Constraint& c) { return c.source == style.source; });
    if (count > 0) legend.push_back(mark(style.shape, style.color, style.label, static_cast<std::size_t>(count)));
  }
}

void addPoints(const SceneInput& in, std::vector<LegendItem>& legend) {
  const ViewOptions& o = in.options;
  const MeshState& state = in.state;
  if (o.boundaryPoints) {
    std::size_t kept = 0;
    std::size_t placed = 0;
    std::size_t split = 0;
    if (state.mesh.points.empty()) {
      for (const std::size_t i : distinctBoundaryPoints(state)) ++(state.boundary[i].kept ? kept : placed);
    }
    for (const VertexKind kind : state.mesh.kinds) {
      if (kind == VertexKind::kept) ++kept;
      if (kind == VertexKind::boundary) ++placed;
      if (kind == VertexKind::split) ++split;
    }
    if (kept > 0) legend.push_back(mark(Shape::square, in.theme.kept, "input point", kept));
    if (placed > 0) legend.push_back(mark(Shape::circle, in.theme.placed, "boundary point", placed));
    if (split > 0) legend.push_back(mark(Shape::ring, in.theme.placed, "split of a boundary edge", split));
  }
  if (o.fronts) {
    const std::size_t first = frontInMesh(state.mesh, state.front1).size();
    const std::size_t second = frontInMesh(state.mesh, state.front2).size();
    if (first > 0) legend.push_back(mark(Shape::circle, in.theme.front1, "first front", first));
    if (second > 0) legend.push_back(mark(Shape::diamond, in.theme.front2, "second front", second));
  }
  if (o.steiner) {
    const auto count = std::count(state.mesh.kinds.begin(), state.mesh.kinds.end(), VertexKind::steiner);
    if (count > 0) {
      legend.push_back(mark(Shape::triangle, in.theme.steiner, "Steiner point", static_cast<std::size_t>(count)));
    }
  }
}

void addDegrees(const Layer& degrees, std::vector<LegendItem>& legend) {
  for (const MarkBatch& batch : degrees.marks)
    legend.push_back(mark(batch.shape, batch.fill,
                          batch.shape == kFewer ? "vertex of few triangles" : "vertex of many triangles",
                          batch.at.size()));
}

void addFill(const SceneInput& in, std::vector<LegendItem>& legend) {
  const ViewOptions& o = in.options;
  if (!o.triangulation || in.state.mesh.triangles.empty()) return;
  if (o.fill == TriangleFill::density) legend.push_back(rankRamp(in));
  if (o.fill != TriangleFill::plain && o.fill != TriangleFill::density) {
    const MeasureScale scale = scaleOf(o.fill);
    LegendItem ramp = item(Sample::ramp, std::string(name(o.fill)));
    constexpr int kSteps = 16;
    for (int i = 0; i < kSteps; ++i) {
      const double t = (i + 0.5) / kSteps;
      ramp.ramp.push_back(measureColor(o, in.theme, scale.good + t * (scale.bound - scale.good)));
    }
    ramp.low = compact(scale.good).append(scale.unit);
    ramp.high = compact(scale.bound).append(scale.unit);
    legend.push_back(std::move(ramp));
    legend.push_back(fillItem(in.theme.overBound, std::string(scale.beyond)));
  }
  if (o.obtuse) {
    std::string count;
    if (in.quality != nullptr) {
      count = fmt::format("{} of {}", grouped(in.quality->obtuse), grouped(in.quality->triangles));
    }
    legend.push_back(fillItem(in.theme.obtuse, "obtuse", std::move(count)));
  }
}

/// "aspect ratio 2.5 to 2.6", or "aspect ratio ≥ 2.5" where it is open upwards.
void addBrush(const SceneInput& in, std::size_t brushed, std::vector<LegendItem>& legend) {
  const Brush& brush = in.options.brush;
  if (!brush.on || !in.options.triangulation || in.state.mesh.triangles.empty()) return;
  const std::string what(brush.measure == TriangleFill::aspect ? "aspect ratio" : name(brush.measure));
  const std::string low = compact(brush.low, 4);
  const bool open = brush.high == std::numeric_limits<double>::max();
  legend.push_back(
      fillItem(in.theme.selection,
               open ? fmt::format("{} ≥ {}", what, low) : fmt::format("{} {} to {}", what, low, compact(brush.high, 4)),
               grouped(brushed)));
}

void addWorst(const SceneInput& in, std::vector<LegendItem>& legend) {
  if (!in.options.worst || in.quality == nullptr || in.quality->triangles == 0) return;
  struct Row {
    const char* label;
    double value;
    double bound;
  };
  const std::array<Row, 3> rows{{{"worst aspect ratio", in.quality->aspectMax, Bounds::aspect},
                                 {"worst area ratio", in.quality->areaRatioMax, Bounds::areaRatio},
                                 {"worst edge ratio", in.quality->edgeRatioMax, Bounds::edgeRatio}}};
  for (int i = 0; i < 3; ++i) {
    const Row& row = rows[static_cast<std::size_t>(i)];
    legend.push_back(lineItem(
        Sample::circle, worstStyle(in.theme, i), row.label,
        fmt::format("{} {} {}", besideBound(row.value, row.bound, 2), row.value < row.bound ? "<" : "≥", row.bound)));
  }
}

/// What a phase of an insertion draws.
void addPhase(const SceneInput& in, std::vector<LegendItem>& legend) {
  const Insertion& insertion = *in.insertion->insertion;
  const Theme& theme = in.theme;
  const bool circumcircle = measuresCircumcircle(insertion);
  switch (in.insertion->phase) {
    case InsertionPhase::candidate:
      if (insertion.candidate.exists()) legend.push_back(fillItem(faded(theme.candidate, 0.25), "candidate"));
      if (insertion.splits.exists())
        legend.push_back(lineItem(Sample::line, splitLine(theme), "boundary edge to be split"));
      if (!insertion.measured) break;
      legend.push_back(lineItem(circumcircle ? Sample::circle : Sample::line, measuredLine(theme),
                                circumcircle ? "circumcircle, R" : "measured length",
                                compact(insertion.measured->length)));
      legend.push_back(lineItem(Sample::circle, limitCircle(theme), "limit", compact(insertion.measured->limit)));
      break;
    case InsertionPhase::walk:
      if (insertion.candidate.exists()) legend.push_back(fillItem(faded(theme.candidate, 0.25), "candidate"));
      if (insertion.walk.empty()) break;
      legend.push_back(lineItem(Sample::line, walkLine(theme), "walk"));
      legend.push_back(fillItem(faded(theme.selection, 0.28), "triangles on the way", grouped(insertion.walk.size())));
      break;
    case InsertionPhase::cavity: {
      LegendItem gone = item(Sample::hatch, "cavity: gives way", grouped(insertion.cavity.triangles().size()));
      gone.fill = theme.removed;
      legend.push_back(std::move(gone));
      legend.push_back(lineItem(Sample::circle, cavityCircle(theme), "their circumcircles"));
      legend.push_back(
          lineItem(Sample::line, rimLine(theme), "rim: edges that stay", grouped(insertion.cavity.rim().size())));
      break;
    }
    case InsertionPhase::filled:
      break;
  }
}

void addDecision(const SceneInput& in, std::vector<LegendItem>& legend) {
  if (in.insertion != nullptr) return addPhase(in, legend);
  if (!in.options.decision || in.current == nullptr) return;
  const bool moves = does(*in.current, kMoves);
  if (!moves && !does(*in.current, kInserts)) return;
  LegendItem made = item(Sample::hatch, moves ? "changed by this decision" : "new triangles");
  made.fill = in.theme.created;
  legend.push_back(std::move(made));
  legend.push_back(lineItem(Sample::line, {in.theme.removed, 1.6f, Dash::dotted, false}, "removed edges"));
}

}  // namespace

std::vector<LegendItem> buildLegend(const SceneInput& in, const Scene& scene) {
  std::vector<LegendItem> legend;
  addCells(in, legend);
  addConstraints(in, legend);
  addPoints(in, legend);
  addDegrees(scene.layer(LayerId::degrees), legend);
  addFill(in, legend);
  addBrush(in, scene.brushed, legend);
  addWorst(in, legend);
  addDecision(in, legend);
  return legend;
}

}  // namespace detail
}  // namespace triscope
