#include "render/scene_shapes.h"

#include <utility>

namespace triscope::detail {

MarkBatch oneMark(Point p, Shape shape, float size, Color fill, Color outline) {
  MarkBatch batch;
  batch.at.push_back(p);
  batch.shape = shape;
  batch.size = size;
  batch.fill = fill;
  batch.outline = outline;
  return batch;
}

LineBatch polyline(std::vector<Point> points, bool closed, LineStyle style) {
  LineBatch batch;
  batch.style = style;
  const auto n = static_cast<std::uint32_t>(points.size());
  for (std::uint32_t i = 0; i + 1 < n; ++i) batch.segments.push_back({i, i + 1});
  if (closed && n > 2) batch.segments.push_back({n - 1, 0});
  batch.points = std::move(points);
  return batch;
}

LineBatch outlineOf(const Mesh& mesh, Slot slot, LineStyle style) {
  const Triangle& t = triangleAt(mesh, slot);
  return polyline({pointOf(mesh, t.v[0]), pointOf(mesh, t.v[1]), pointOf(mesh, t.v[2])}, true, style);
}

TriangleBatch patch(const Mesh& mesh, const std::vector<Slot>& slots, Color fill, bool hatched) {
  TriangleBatch batch;
  for (const Slot slot : slots) {
    const auto first = static_cast<std::uint32_t>(batch.points.size());
    for (const Vertex v : triangleAt(mesh, slot).v) batch.points.push_back(pointOf(mesh, v));
    batch.triangles.push_back({first, first + 1, first + 2});
  }
  batch.fills.push_back(fill);
  batch.hatched = hatched;
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
