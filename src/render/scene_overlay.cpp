// The small layers on top: the current decision, the three worst triangles, the selection.
#include <algorithm>
#include <cmath>
#include <string>

#include "core/density/wanted.h"
#include "core/geometry/circumcircle.h"
#include "core/quality/bound_figure.h"
#include "core/words/vocabulary.h"
#include "render/pick.h"
#include "render/scene_parts.h"
#include "render/scene_shapes.h"
#include "render/star.h"

namespace triscope::detail {
namespace {

using std::size_t;

// Empty for a vertex that no triangle uses.
Star liveStar(const Mesh& mesh, Vertex vertex) {
  Star star;
  const Slot slot = mesh.vertexTriangle[vertex];
  if (slot.exists() && mesh.alive(slot)) starOf(mesh, vertex, star);
  return star;
}

LineBatch cellOutline(const Quadtree& tree, const Cell& cell, LineStyle style) {
  const Point lo = tree.corner(cell);
  const double side = tree.side(cell);
  return polygon({lo, {lo.x + side, lo.y}, {lo.x + side, lo.y + side}, {lo.x, lo.y + side}}, style);
}

std::vector<Slot> slotsCreated(const Mesh& mesh, const Event& event) {
  std::vector<Slot> slots;
  if (event.created == kNoId) return slots;
  for (const Slot slot : mesh.ids.keys())
    if (mesh.ids[slot].n - event.created < event.createdCount && mesh.alive(slot)) slots.push_back(slot);
  return slots;
}

// In steps 1 to 4 what is measured is the circumradius about the proposed point.
void addCircumcircle(const SceneInput& in, Layer& layer) {
  const Event& event = *in.current;
  const bool step = wordsOf(event.rule).family == Family::step && event.rule != Rule::step5;
  if (!step || !(event.measured > 0.0)) return;
  addCircle(in, layer, {event.at, event.measured, 0.0f, {in.theme.candidate, 1.3f, Dash::solid, false}});
}

void addInsertion(const SceneInput& in, Layer& layer) {
  const Mesh& mesh = in.state.mesh;
  const Event& event = *in.current;
  if (!mesh.points.has(Vertex(event.vertex))) {
    layer.marks.push_back(oneMark(event.at, Shape::circle, 8.0f, in.theme.candidate, in.theme.background));
    return;
  }
  const Vertex vertex(event.vertex);
  const Star star = liveStar(mesh, vertex);
  const std::vector<Vertex> rim = rimVertices(mesh, star);
  layer.triangles.push_back(hatchedPatch(mesh, slotsOf(star), in.theme.created));
  std::vector<Point> around;
  around.reserve(rim.size());
  for (const Vertex v : rim) around.push_back(pointOf(mesh, v));
  layer.lines.push_back(polygon(std::move(around), {in.theme.created, 1.8f, Dash::solid, false}));
  LineBatch removed;
  removed.style = {in.theme.removed, 1.6f, Dash::dotted, false};
  for (const auto& edge : edgesBefore(mesh, rim)) {
    const auto first = static_cast<std::uint32_t>(removed.points.size());
    removed.points.push_back(pointOf(mesh, edge[0]));
    removed.points.push_back(pointOf(mesh, edge[1]));
    removed.segments.push_back({first, first + 1});
  }
  if (!removed.segments.empty()) layer.lines.push_back(std::move(removed));
  addCircumcircle(in, layer);
  layer.marks.push_back(oneMark(pointOf(mesh, vertex), Shape::circle, 8.0f, in.theme.candidate, in.theme.background));
}

/// A cross where it was to be, and why not.
void addRefusalMark(const SceneInput& in, Layer& layer) {
  const Event& event = *in.current;
  layer.marks.push_back(oneMark(event.at, Shape::cross, 9.0f, in.theme.refused, in.theme.background));
  if (in.options.labels)
    layer.labels.push_back(labelAt(in, event.at, std::string(name(event.refusal)), in.theme.refused));
}

void addRefusal(const SceneInput& in, Layer& layer) {
  const Mesh& mesh = in.state.mesh;
  const Event& event = *in.current;
  const Slot slot = slotOf(mesh, TriangleId(event.subject));
  if (event.kind == EventKind::vertex_refused && slot.exists()) {
    layer.lines.push_back(outlineOf(mesh, slot, {in.theme.candidate, 2.0f, Dash::solid, false}));
  }
  addCircumcircle(in, layer);
  if (event.kind == EventKind::vertex_kept && mesh.points.has(Vertex(event.vertex))) {
    const Point stays = mesh.points[Vertex(event.vertex)];
    layer.lines.push_back(polyline({stays, event.at}, {in.theme.refused, 1.4f, Dash::dotted, false}));
    layer.marks.push_back(oneMark(stays, Shape::ring, 9.0f, in.theme.candidate, {0, 0, 0, 0}));
  }
  addRefusalMark(in, layer);
}

void addMove(const SceneInput& in, Layer& layer) {
  const Mesh& mesh = in.state.mesh;
  const Event& event = *in.current;
  if (!mesh.points.has(Vertex(event.vertex))) return;
  const Star star = liveStar(mesh, Vertex(event.vertex));
  // Flips that followed the move may have made triangles beyond the star.
  std::vector<Slot> slots = slotsOf(star);
  for (const Slot slot : slotsCreated(mesh, event)) {
    if (std::find(slots.begin(), slots.end(), slot) == slots.end()) slots.push_back(slot);
  }
  layer.triangles.push_back(hatchedPatch(mesh, slots, in.theme.created));
  LineBatch spokes;  // where the edges to the vertex were
  spokes.style = {in.theme.removed, 1.4f, Dash::dotted, false};
  spokes.points.push_back(event.from);
  for (const Vertex v : rimVertices(mesh, star)) {
    spokes.segments.push_back({0, static_cast<std::uint32_t>(spokes.points.size())});
    spokes.points.push_back(pointOf(mesh, v));
  }
  layer.lines.push_back(std::move(spokes));
  layer.lines.push_back(polyline({event.from, event.at}, {in.theme.candidate, 2.2f, Dash::solid, false}));
  layer.marks.push_back(oneMark(event.from, Shape::ring, 7.0f, in.theme.removed, {0, 0, 0, 0}));
  layer.marks.push_back(oneMark(event.at, Shape::circle, 8.0f, in.theme.candidate, in.theme.background));
}

void addRemoval(const SceneInput& in, Layer& layer) {
  const Mesh& mesh = in.state.mesh;
  const Event& event = *in.current;
  layer.triangles.push_back(hatchedPatch(mesh, slotsCreated(mesh, event), in.theme.created));
  // The place of a vertex outlives it.
  const Point was = mesh.points.has(Vertex(event.vertex)) ? mesh.points[Vertex(event.vertex)] : event.at;
  layer.marks.push_back(oneMark(was, Shape::cross, 9.0f, in.theme.removed, in.theme.background));
}

void addPatch(const SceneInput& in, Layer& layer) {
  const Mesh& mesh = in.state.mesh;
  const Event& event = *in.current;
  layer.triangles.push_back(hatchedPatch(mesh, slotsCreated(mesh, event), in.theme.created));
  const Slot slot = slotOf(mesh, TriangleId(event.subject));
  if (slot.exists()) layer.lines.push_back(outlineOf(mesh, slot, {in.theme.candidate, 2.0f, Dash::solid, false}));
  if (event.kind == EventKind::edit_kept) {
    layer.marks.push_back(oneMark(event.at, Shape::ring, 9.0f, in.theme.candidate, {0, 0, 0, 0}));
    return;
  }
  addRefusalMark(in, layer);
}

void addCell(const SceneInput& in, Layer& layer) {
  const Quadtree& tree = in.state.tree;
  const LineStyle strong{in.theme.candidate, 2.4f, Dash::solid, false};
  if (const Cell* const cell = cellOf(tree, in.current->subject))
    layer.lines.push_back(cellOutline(tree, *cell, strong));
  const LineStyle made{in.theme.created, 1.4f, Dash::dashed, false};
  if (in.current->kind != EventKind::cell_split || in.current->created == kNoId) return;
  for (std::int64_t i = 0; i < 4; ++i)
    if (const Cell* const cell = cellOf(tree, in.current->created + i))
      layer.lines.push_back(cellOutline(tree, *cell, made));
}

void addWorst(const SceneInput& in, Layer& layer, int which, Slot slot, const char* label, double value, double bound) {
  const Mesh& mesh = in.state.mesh;
  if (!mesh.triangles.has(slot) || !mesh.alive(slot)) return;
  const Triangle& t = triangleAt(mesh, slot);
  const Circumcircle circle = circumcircle(pointOf(mesh, t.v[0]), pointOf(mesh, t.v[1]), pointOf(mesh, t.v[2]));
  if (!std::isfinite(circle.squaredRadius)) return;
  // One triangle may be the worst in more than one respect: the circles stay apart.
  const float least = 12.0f + 5.0f * static_cast<float>(which);
  const LineStyle style = worstStyle(in.theme, which);
  const double radius = std::sqrt(circle.squaredRadius) * (1.05 + 0.12 * which);
  addCircle(in, layer, {circle.centre, radius, least, style});
  if (!in.options.labels) return;
  Label text = labelAt(in, circle.centre, std::string(label) + " " + besideBound(value, bound, 2), style.color);
  text.dx = least + 3.0f;
  text.dy = -least;
  text.around = 0.75 * radius;
  layer.labels.push_back(std::move(text));
}

}  // namespace

LineStyle worstStyle(const Theme& theme, int which) {
  switch (which) {
    case 0:
      return {theme.worstAspect, 2.0f, Dash::solid, false};
    case 1:
      return {theme.worstArea, 2.0f, Dash::dashed, false};
    default:
      return {theme.worstEdge, 2.0f, Dash::dash_dotted, false};
  }
}

void buildDecision(const SceneInput& in, Layer& layer) {
  if (in.insertion != nullptr) return buildInsertion(in, layer);
  if (!in.options.decision || in.current == nullptr) return;
  const Event& event = *in.current;
  const auto mark = [&](Shape shape, float size, Color color, Color halo) {
    layer.marks.push_back(oneMark(event.at, shape, size, color, halo));
  };
  switch (wordsOf(event.kind).picture) {
    case Picture::none:
      break;
    case Picture::place:
      mark(Shape::ring, 15.0f, in.theme.candidate, {0, 0, 0, 0});
      break;
    case Picture::cell:
      addCell(in, layer);
      break;
    case Picture::insertion:
      addInsertion(in, layer);
      break;
    case Picture::refusal:
      addRefusal(in, layer);
      break;
    case Picture::move:
      addMove(in, layer);
      break;
    case Picture::removal:
      addRemoval(in, layer);
      break;
    case Picture::carved:
      mark(Shape::cross, 9.0f, in.theme.removed, in.theme.background);
      break;
    case Picture::patch:
      addPatch(in, layer);
      break;
    case Picture::failure:
      mark(Shape::cross, 16.0f, in.theme.refused, in.theme.background);
      break;
  }
}

void buildWorst(const SceneInput& in, Layer& layer) {
  if (!in.options.worst || in.quality == nullptr || in.quality->triangles == 0) return;
  addWorst(in, layer, 0, in.quality->aspectAt, "aspect", in.quality->aspectMax, Bounds::aspect);
  addWorst(in, layer, 1, in.quality->areaRatioAt, "area ratio", in.quality->areaRatioMax, Bounds::areaRatio);
  addWorst(in, layer, 2, in.quality->edgeRatioAt, "edge ratio", in.quality->edgeRatioMax, Bounds::edgeRatio);
}

void buildSelection(const SceneInput& in, Layer& layer) {
  const Selection& s = in.options.selection;
  const Mesh& mesh = in.state.mesh;
  const LineStyle line{in.theme.selection, 2.6f, Dash::solid, false};
  if (!isPartOf(in.state, s)) return;
  switch (s.kind) {
    case Selection::Kind::none:
      break;
    case Selection::Kind::vertex:
      layer.triangles.push_back(patch(mesh, slotsOf(liveStar(mesh, s.vertex())), faded(in.theme.selection, 0.22)));
      layer.marks.push_back(oneMark(pointOf(mesh, s.vertex()), Shape::ring, 13.0f, in.theme.selection, {0, 0, 0, 0}));
      break;
    case Selection::Kind::edge: {
      const Half half = s.half();
      layer.lines.push_back(polyline({pointOf(mesh, startOf(mesh, half)), pointOf(mesh, endOf(mesh, half))}, line));
      break;
    }
    case Selection::Kind::triangle:
      layer.triangles.push_back(patch(mesh, {s.slot()}, faded(in.theme.selection, 0.3)));
      layer.lines.push_back(outlineOf(mesh, s.slot(), line));
      break;
    case Selection::Kind::cell:
      layer.lines.push_back(cellOutline(in.state.tree, in.state.tree.cells[static_cast<size_t>(s.index)], line));
      break;
  }
}

}  // namespace triscope::detail
