#include "support/edits.h"

#include <fmt/format.h>

#include "core/base/index_text.h"
#include "core/mesh/move.h"
#include "core/mesh/remove.h"

namespace triscope::support {

std::string editAtRandom(MeshState& state, Random& random, EditCounts& counts) {
  Mesh& mesh = state.mesh;
  const Box& box = state.domain->bounds;
  const Vertex vertex(random.below(mesh.points.size()));
  const bool inner = mesh.vertexTriangle[vertex].exists() && !mesh.vertexEdge[vertex].exists();
  switch (random.below(8)) {
    case 0: {
      const EdgeId edge(random.below(mesh.edges.size()));
      if (splitBoundary(mesh, *state.domain, state.tree, edge, 0.0, state.room.placing).vertex.exists()) ++counts.split;
      return fmt::format("split of boundary edge {}", edge);
    }
    case 1: {
      if (!inner) return "nothing";
      if (removeVertex(mesh, vertex)) ++counts.removed;
      return fmt::format("removal of vertex {}", vertex);
    }
    case 2:
    case 3:
    case 4: {
      if (!inner) return "nothing";
      const double reach = 0.05 * box.width();
      const Point to = pointOf(mesh, vertex) + Point{random.between(-reach, reach), random.between(-reach, reach)};
      MoveLog log;
      if (moveVertex(mesh, vertex, to, log)) ++counts.moved;
      return fmt::format("move of vertex {} to {}, {}", vertex, to.x, to.y);
    }
    default: {
      const Point p{random.between(box.lo.x, box.hi.x), random.between(box.lo.y, box.hi.y)};
      if (place(mesh, state.tree, p, mesh.lastTriangle, VertexKind::steiner, {}, state.room.placing).vertex.exists())
        ++counts.inserted;
      return fmt::format("insertion at {}, {}", p.x, p.y);
    }
  }
}

}  // namespace triscope::support
