// Small triangulations for tests of the mesh's operations, built and judged without the stages.
#pragma once

#include <array>
#include <ostream>
#include <string>
#include <vector>

#include "core/mesh/mesh.h"
#include "support/ids.h"
#include "support/random.h"

namespace triscope::support {

/// Two triangles over the box; its four sides are boundary edges of one curve each.
Mesh boxMesh(Point lo, Point hi);

/// A mesh from lists of points and of counter-clockwise triangles, sound but for overlaps.
Mesh meshOf(std::vector<Point> points, std::vector<std::array<int, 3>> triangles);

/// Bowyer-Watson insertion from the last triangle. None when a vertex is there already.
Vertex insert(Mesh& mesh, Point p);

/// The box of the points, widened by its larger side, with the points in it.
Mesh triangulationOf(const std::vector<Point>& points);

/// Live triangles as corner numbers, each from its lowest, in order.
std::vector<std::array<Vertex, 3>> trianglesOf(const Mesh& mesh);
/// Live triangles as corner places, each from its least, in order: comparable between meshes numbered differently.
std::vector<std::array<Point, 3>> trianglesByPlace(const Mesh& mesh);

std::vector<Slot> liveSlots(const Mesh& mesh);

/// Names the first difference between two meshes, byte for byte in every array; empty when there is none.
std::string difference(const Mesh& a, const Mesh& b);

/// Fails unless no vertex lies inside the circumcircle of any triangle: every triangle against every vertex, decided
/// by rational arithmetic. Only for meshes without inner boundary.
void expectDelaunayByBruteForce(const Mesh& mesh);

/// Kinds of point sets that triangulations go wrong on.
struct PointSet {
  const char* name;
  std::vector<Point> points;
};
inline void PrintTo(const PointSet& set, std::ostream* out) { *out << set.name; }
std::vector<PointSet> difficultPoints();

std::vector<Point> randomPoints(Random& random, std::size_t count, Point lo, Point hi);

}  // namespace triscope::support
