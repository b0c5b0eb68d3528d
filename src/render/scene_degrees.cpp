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

IrregularVertices irregularVertices(const SceneInput& in) {
  IrregularVertices found;
  const MeshState& state = in.state;
  if (!in.options.degrees || isBoxed(state.mesh)) return found;
  const Per<Vertex, std::int8_t> excess = degreeExcess(state.mesh);
  for (const Vertex v : excess.keys()) {
    if (excess[v] < 0) found.fewer.push_back(v);
    if (excess[v] > 0) found.more.push_back(v);
  }
  return found;
}

void buildDegrees(const SceneInput& in, Layer& layer) {
  const IrregularVertices irregular = irregularVertices(in);
  const auto add = [&](const std::vector<Vertex>& vertices, Shape shape, float size, Color color) {
    MarkBatch batch = markBatch(shape, size, color, in.theme.background);
    for (const Vertex v : vertices) {
      batch.at.push_back(pointOf(in.state.mesh, v));
      batch.spacing.push_back(spacingOf(in.state, v));
    }
    if (!batch.at.empty()) layer.marks.push_back(std::move(batch));
  };
  add(irregular.fewer, kFewer, 7.0f, in.theme.fewer);
  add(irregular.more, kMore, 7.0f, in.theme.more);
}

}  // namespace triscope::detail
