#include "core/mesh/degrees.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/trig.h"

namespace triscope {

Per<Vertex, std::int8_t> degreeExcess(const Mesh& mesh) {
  Per<Vertex, int> count(mesh.points.size(), 0);
  Per<Vertex, double> angle(mesh.points.size(), 0.0);  // of those on a boundary
  for (const Slot slot : mesh.triangles.keys()) {
    if (!mesh.alive(slot)) continue;
    const Triangle& t = triangleAt(mesh, slot);
    for (int i = 0; i < 3; ++i) {
      const Vertex v = t.v[i];
      ++count[v];
      if (!mesh.vertexEdge[v].exists()) continue;
      const Point apex = pointOf(mesh, v);
      angle[v] +=
          std::fabs(trig::angleBetween(pointOf(mesh, t.v[next3(i)]) - apex, pointOf(mesh, t.v[prev3(i)]) - apex));
    }
  }
  // Half-way between two numbers either is right: of a right angle one triangle or two.
  constexpr double kHalf = 0.5 + 1e-9;
  Per<Vertex, std::int8_t> excess(mesh.points.size(), 0);
  for (const Vertex v : mesh.points.keys()) {
    if (count[v] == 0) continue;
    const double sixths = mesh.vertexEdge[v].exists() ? angle[v] / (60.0 * trig::kDegree) : 6.0;
    const int fewest = std::max(1, static_cast<int>(std::ceil(sixths - kHalf)));
    const int most = std::max(1, static_cast<int>(std::floor(sixths + kHalf)));
    const int beyond = count[v] < fewest ? count[v] - fewest : count[v] > most ? count[v] - most : 0;
    excess[v] = static_cast<std::int8_t>(std::clamp(beyond, -100, 100));
  }
  return excess;
}

}  // namespace triscope
