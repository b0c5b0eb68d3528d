#include "render/scene_shapes.h"

#include <utility>

namespace triscope::detail {

MarkBatch oneMark(Point p, Shape shape, float size, Color fill, Color outline) {
  MarkBatch batch = markBatch(shape, size, fill, outline);
  batch.at.push_back(p);
  return batch;
}

MarkBatch markBatch(Shape shape, float size, Color fill, Color outline) {
  MarkBatch batch;
  batch.shape = shape;
  batch.size = size;
  batch.fill = fill;
  batch.outline = outline;
  return batch;
}

LineBatch polyline(std::vector<Point> points, LineStyle style) {
  LineBatch batch;
  batch.style = style;
  const auto n = static_cast<std::uint32_t>(points.size());
  for (std::uint32_t i = 0; i + 1 < n; ++i) batch.segments.push_back({i, i + 1});
  batch.points = std::move(points);
  return batch;
}

LineBatch polygon(std::vector<Point> points, LineStyle style) {
  LineBatch batch = polyline(std::move(points), style);
  const auto n = static_cast<std::uint32_t>(batch.points.size());
  if (n > 2) batch.segments.push_back({n - 1, 0});
  return batch;
}

LineBatch outlineOf(const Mesh& mesh, Slot slot, LineStyle style) {
  const Triangle& t = triangleAt(mesh, slot);
  return polygon({pointOf(mesh, t.v[0]), pointOf(mesh, t.v[1]), pointOf(mesh, t.v[2])}, style);
}

TriangleBatch patch(const Mesh& mesh, const std::vector<Slot>& slots, Color fill) {
  TriangleBatch batch;
  for (const Slot slot : slots) {
    const auto first = static_cast<std::uint32_t>(batch.points.size());
    for (const Vertex v : triangleAt(mesh, slot).v) batch.points.push_back(pointOf(mesh, v));
    batch.triangles.push_back({first, first + 1, first + 2});
  }
  batch.fills.push_back(fill);
  return batch;
}

TriangleBatch hatchedPatch(const Mesh& mesh, const std::vector<Slot>& slots, Color fill) {
  TriangleBatch batch = patch(mesh, slots, fill);
  batch.hatched = true;
  return batch;
}

Label labelAt(const SceneInput& in, Point p, std::string text, Color color) {
  Label label;
  label.at = p;
  label.dx = 9.0f;
  label.dy = -9.0f;
  label.text = std::move(text);
  label.color = color;
  label.halo = in.theme.background;
  return label;
}

void addCircle(const SceneInput& in, Layer& layer, const Circle& circle) {
  Circle ring = circle;
  ring.style = {faded(in.theme.background, 0.8), circle.style.width + 2.6f, Dash::solid, false};
  layer.circles.push_back(ring);
  layer.circles.push_back(circle);
}

}  // namespace triscope::detail
