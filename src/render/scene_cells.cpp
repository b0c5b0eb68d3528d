// The background quadtree, its constraints, and the boundary curves: what Figure 1 shows.
#include <algorithm>
#include <cmath>

#include "render/scene_parts.h"

namespace triscope::detail {
namespace {

bool isLeaf(const Cell& cell) { return cell.child < 0; }

// Segments per curve, fine enough that an arc of 1000 px radius is off by less than a tenth of a pixel.
int segmentsOf(const Curve& curve) {
  switch (curve.kind) {
    case CurveKind::line:
      return 1;
    case CurveKind::arc:
      return std::max(2, static_cast<int>(std::ceil(std::fabs(curve.sweptAngle) * 80.0)));
    case CurveKind::spline:
      return std::max(2, 12 * (static_cast<int>(curve.knots.size()) - 1));
  }
  return 1;
}

}  // namespace

bool classified(const Quadtree& tree) {
  return std::any_of(tree.cells.begin(), tree.cells.end(),
                     [](const Cell& c) { return isLeaf(c) && c.type != CellType::outside; });
}

RankRange rankRange(const Quadtree& tree) {
  const bool types = classified(tree);
  RankRange range{255, 1};
  for (const Cell& cell : tree.cells) {
    if (!isLeaf(cell) || (types && cell.type == CellType::outside)) continue;
    range.lowest = std::min<int>(range.lowest, cell.density);
    range.highest = std::max<int>(range.highest, cell.density);
  }
  if (range.lowest > range.highest) return {};
  return range;
}

bool drawsCells(const SceneInput& in) {
  const ViewOptions& o = in.options;
  const bool covered = o.triangulation && !in.state.mesh.triangles.empty() && o.fill != TriangleFill::plain;
  return o.quadtree && !in.state.tree.cells.empty() && !covered;
}

void buildCells(const SceneInput& in, Layer& layer) {
  const Quadtree& tree = in.state.tree;
  if (!drawsCells(in)) return;
  const bool types = classified(tree);
  const RankRange range = rankRange(tree);
  // Under a triangulation the colours stay behind its edges.
  const double strength = in.options.triangulation && !in.state.mesh.triangles.empty() ? 0.6 : 1.0;
  SquareBatch batch;
  batch.outline = {in.theme.cellLine, 0.8f, Dash::solid, true};
  batch.squares.reserve(tree.cells.size());
  for (const Cell& cell : tree.cells) {
    if (!isLeaf(cell)) continue;
    const bool outside = types && cell.type == CellType::outside;
    if (outside && !in.options.outsideCells) continue;
    Color fill{0, 0, 0, 0};
    if (outside) {
      fill = cellTypeColor(in.theme, CellType::outside);
    } else if (in.options.cells == CellColoring::rank) {
      fill = faded(rankColor(in.options.scale, in.theme, cell.density, range.lowest, range.highest), strength);
    } else if (in.options.cells == CellColoring::type) {
      fill = faded(cellTypeColor(in.theme, types ? cell.type : CellType::white), strength);
    }
    batch.squares.push_back({tree.corner(cell), tree.side(cell), fill});
  }
  layer.squares.push_back(std::move(batch));
}

void buildBoundary(const SceneInput& in, Layer& layer) {
  if (!in.options.boundary || !in.state.domain) return;
  LineBatch batch;
  batch.style = {in.theme.boundary, 1.6f, Dash::solid, false};
  for (const Curve& curve : in.state.domain->curves) {
    const int n = segmentsOf(curve);
    const auto first = static_cast<std::uint32_t>(batch.points.size());
    for (int i = 0; i <= n; ++i) {
      batch.points.push_back(i == n ? curve.b : pointAt(curve, static_cast<double>(i) / n));
      if (i > 0) {
        const auto at = first + static_cast<std::uint32_t>(i);
        batch.segments.push_back({at - 1, at});
      }
    }
  }
  layer.lines.push_back(std::move(batch));
}

std::vector<SourceStyle> sourceStyles(const Theme& theme) {
  const Color black = theme.text;
  std::vector<SourceStyle> styles{
      {Rule::user_request, Shape::square, theme.dark ? okabe::purple : rgb(0xA0487A), "asked for"},
      {Rule::curvature, Shape::circle, theme.constraint, "curvature"},
      {Rule::corner, Shape::triangle, black, "corner"},
      {Rule::gap, Shape::diamond, theme.dark ? okabe::sky : okabe::blue, "gap"},
      {Rule::short_edge, Shape::cross, theme.dark ? rgb(0x35C79A) : rgb(0x007A5A), "short edge"}};
  for (int k = 0; k < kRuleCount; ++k) {  // those that have no mark of their own
    const auto rule = static_cast<Rule>(k);
    if (wordsOf(rule).family == Family::source && std::ranges::count(styles, rule, &SourceStyle::source) == 0)
      styles.push_back({rule, Shape::ring, theme.text, name(rule).data()});
  }
  return styles;
}

void buildConstraints(const SceneInput& in, Layer& layer) {
  if (!in.options.constraints) return;
  for (const SourceStyle& style : sourceStyles(in.theme)) {
    MarkBatch batch;
    batch.shape = style.shape;
    batch.size = 8.0f;
    batch.fill = style.color;
    batch.outline = in.theme.background;
    for (const Constraint& constraint : in.state.constraints) {
      if (constraint.source != style.source) continue;
      // Constraints come in order along a curve: the one before is the nearest, or as good as.
      const double gap = batch.at.empty() ? 1e300 : 2.0 * distance(batch.at.back(), constraint.at);
      batch.at.push_back(constraint.at);
      batch.spacing.push_back(static_cast<float>(std::min(2.0 * constraint.length, gap)));
    }
    if (!batch.at.empty()) layer.marks.push_back(std::move(batch));
  }
}

}  // namespace triscope::detail
