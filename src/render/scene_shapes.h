// Small shapes that the overlays are made of.
#pragma once

#include <string>
#include <vector>

#include "render/scene_parts.h"

namespace triscope::detail {

MarkBatch oneMark(Point p, Shape shape, float size, Color fill, Color outline);
/// Marks of one look, none yet.
MarkBatch markBatch(Shape shape, float size, Color fill, Color outline);
LineBatch polyline(std::vector<Point> points, LineStyle style);
LineBatch polygon(std::vector<Point> points, LineStyle style);
/// The edges of a triangle.
LineBatch outlineOf(const Mesh& mesh, Slot slot, LineStyle style);
/// Triangles filled with one colour.
TriangleBatch patch(const Mesh& mesh, const std::vector<Slot>& slots, Color fill);
TriangleBatch hatchedPatch(const Mesh& mesh, const std::vector<Slot>& slots, Color fill);
/// A text beside a point.
Label labelAt(const SceneInput& in, Point p, std::string text, Color color);
/// On a ring of background, so that it reads over any fill.
void addCircle(const SceneInput& in, Layer& layer, const Circle& circle);

}  // namespace triscope::detail
