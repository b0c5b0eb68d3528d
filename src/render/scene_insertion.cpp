// The phases of an insertion, over the mesh before it.
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/number.h"
#include "core/geometry/circumcircle.h"
#include "core/mesh/centroid.h"
#include "core/mesh/edit.h"
#include "render/scene_parts.h"
#include "render/scene_shapes.h"

namespace triscope::detail {
namespace {

void addPoint(const SceneInput& in, Layer& layer, bool there) {
  const Point at = in.insertion->insertion->at;
  layer.marks.push_back(there ? oneMark(at, Shape::circle, 8.0f, in.theme.candidate, in.theme.background)
                              : oneMark(at, Shape::ring, 9.0f, in.theme.candidate, {0, 0, 0, 0}));
}

void addCandidate(const SceneInput& in, Layer& layer) {
  const Mesh& mesh = in.state.mesh;
  const Insertion& insertion = *in.insertion->insertion;
  if (insertion.candidate.exists()) {
    layer.triangles.push_back(patch(mesh, {insertion.candidate}, faded(in.theme.candidate, 0.25)));
    layer.lines.push_back(outlineOf(mesh, insertion.candidate, {in.theme.candidate, 2.2f, Dash::solid, false}));
  }
  if (insertion.splits.exists())
    layer.lines.push_back(
        polyline({pointOf(mesh, startOf(mesh, insertion.splits)), pointOf(mesh, endOf(mesh, insertion.splits))},
                 splitLine(in.theme)));
}

/// The measured length as a circle or a line, and what it is held against as a dashed circle.
void addMeasured(const SceneInput& in, Layer& layer) {
  const Insertion& insertion = *in.insertion->insertion;
  if (!insertion.measured) return;
  const Measured& m = *insertion.measured;
  const bool circumcircle = measuresCircumcircle(insertion);
  if (circumcircle) addCircle(in, layer, {m.from, m.length, 0.0f, measuredLine(in.theme)});
  addCircle(in, layer, {m.from, m.limit, 0.0f, limitCircle(in.theme)});
  layer.lines.push_back(polyline({m.from, m.to}, measuredLine(in.theme)));
  if (!in.options.labels) return;
  // Above and below the outermost circle, where nothing of the insertion is in their way.
  const double reach = circumcircle ? std::max(m.length, m.limit) : m.limit;
  const auto beside = [&](Point at, float dy, const std::string& text, Color color) {
    Label label = labelAt(in, at, text, color);
    label.dx = 0.0f;
    label.dy = dy;
    label.anchor = Anchor::centre;
    layer.labels.push_back(std::move(label));
  };
  beside(m.from + Point{0.0, reach}, -7.0f, (circumcircle ? "R " : "length ") + compact(m.length), in.theme.candidate);
  beside(m.from - Point{0.0, reach}, 17.0f, "limit " + compact(m.limit), in.theme.refused);
}

/// Through the middles of the triangles, to the point.
void addWalk(const SceneInput& in, Layer& layer) {
  const Mesh& mesh = in.state.mesh;
  const Insertion& insertion = *in.insertion->insertion;
  if (insertion.walk.empty()) return;
  layer.triangles.push_back(patch(mesh, insertion.walk, faded(in.theme.selection, 0.28)));
  for (const Slot slot : insertion.walk)
    layer.lines.push_back(outlineOf(mesh, slot, {in.theme.selection, 1.4f, Dash::solid, false}));
  std::vector<Point> way;
  way.reserve(insertion.walk.size() + 1);
  for (const Slot slot : insertion.walk) way.push_back(centroidOf(mesh, slot));
  const Point first = way.front();
  way.push_back(insertion.at);
  layer.lines.push_back(polyline(std::move(way), walkLine(in.theme)));
  layer.marks.push_back(oneMark(first, Shape::square, 7.0f, in.theme.candidate, in.theme.background));
}

/// The triangles that give way with their circumcircles, and the rim that stays.
void addCavity(const SceneInput& in, Layer& layer) {
  const Mesh& mesh = in.state.mesh;
  const Cavity& cavity = in.insertion->insertion->cavity;
  const std::vector<Slot> slots(cavity.triangles().begin(), cavity.triangles().end());
  layer.triangles.push_back(hatchedPatch(mesh, slots, in.theme.removed));
  for (const Slot slot : slots) {
    layer.lines.push_back(outlineOf(mesh, slot, {in.theme.removed, 1.4f, Dash::dotted, false}));
    const Triangle& t = triangleAt(mesh, slot);
    const Circumcircle circle = circumcircle(pointOf(mesh, t.v[0]), pointOf(mesh, t.v[1]), pointOf(mesh, t.v[2]));
    if (std::isfinite(circle.squaredRadius))
      layer.circles.push_back({circle.centre, std::sqrt(circle.squaredRadius), 0.0f, cavityCircle(in.theme)});
  }
  LineBatch rim;
  rim.style = rimLine(in.theme);
  for (const Cavity::RimEdge& edge : cavity.rim()) {
    const Half half = halfEdgeOf(mesh, edge);
    const auto first = static_cast<std::uint32_t>(rim.points.size());
    rim.points.push_back(pointOf(mesh, startOf(mesh, half)));
    rim.points.push_back(pointOf(mesh, endOf(mesh, half)));
    rim.segments.push_back({first, first + 1});
  }
  layer.lines.push_back(std::move(rim));
}

}  // namespace

bool measuresCircumcircle(const Insertion& insertion) {
  return insertion.candidate.exists() && insertion.event.rule != Rule::step5;
}

LineStyle splitLine(const Theme& theme) { return {theme.candidate, 2.6f, Dash::solid, false}; }
LineStyle measuredLine(const Theme& theme) { return {theme.candidate, 1.6f, Dash::solid, false}; }
LineStyle limitCircle(const Theme& theme) { return {theme.refused, 1.6f, Dash::dashed, false}; }
LineStyle walkLine(const Theme& theme) { return {theme.candidate, 2.2f, Dash::solid, false}; }
LineStyle rimLine(const Theme& theme) { return {theme.created, 2.2f, Dash::solid, false}; }
LineStyle cavityCircle(const Theme& theme) { return {faded(theme.removed, 0.8), 1.3f, Dash::dotted, false}; }

void buildInsertion(const SceneInput& in, Layer& layer) {
  switch (in.insertion->phase) {
    case InsertionPhase::candidate:
      addCandidate(in, layer);
      addMeasured(in, layer);
      addPoint(in, layer, false);
      break;
    case InsertionPhase::walk:
      addCandidate(in, layer);
      addWalk(in, layer);
      addPoint(in, layer, false);
      break;
    case InsertionPhase::cavity:
      addCavity(in, layer);
      addPoint(in, layer, true);
      break;
    case InsertionPhase::filled:
      break;
  }
}

}  // namespace triscope::detail
