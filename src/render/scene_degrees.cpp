// Vertices of a degree other than six: where the rows of equilateral triangles end or begin. A bent boundary and a size
// that grows need some; the others are what keeps angles from 60°.
#include "core/mesh/degrees.h"
#include "render/scene_parts.h"
#include "render/scene_shapes.h"

namespace triscope::detail {
namespace {

/// Whether some corner of the box around everything still has a triangle. The stage does not tell: its carving may be
/// over, and the next one not begun.
bool isBoxed(const Mesh& mesh) {
  for (const Slot slot : mesh.triangles.keys())
    if (mesh.alive(slot) && touchesHelper(mesh, slot)) return true;
  return false;
}

}  // namespace

void buildDegrees(const SceneInput& in, Layer& layer) {
  const Mesh& mesh = in.state.mesh;
  if (!in.options.degrees || isBoxed(mesh)) return;
  MarkBatch fewer = markBatch(kFewer, 7.0f, in.theme.fewer, in.theme.background);
  MarkBatch more = markBatch(Shape::square, 7.0f, in.theme.more, in.theme.background);
  const Per<Vertex, std::int8_t> excess = degreeExcess(mesh);
  for (const Vertex v : excess.keys()) {
    if (excess[v] == 0) continue;
    MarkBatch& batch = excess[v] < 0 ? fewer : more;
    batch.at.push_back(pointOf(mesh, v));
    batch.spacing.push_back(spacingOf(in.state, v));
  }
  for (MarkBatch* batch : {&fewer, &more})
    if (!batch->at.empty()) layer.marks.push_back(std::move(*batch));
}

}  // namespace triscope::detail
