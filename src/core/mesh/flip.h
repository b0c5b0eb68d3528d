// Edge flips, and the restoration of the Delaunay property by them (C. L. Lawson, 1977).
#pragma once

#include "core/mesh/mesh.h"

namespace triscope {

/// Replaces the edge by the other diagonal of its quadrilateral. The two triangles keep their slots and get new ids.
/// The edge must have two sides, be unconstrained, and its quadrilateral strictly convex. Returns the half-edge of
/// the new diagonal.
Half flipEdge(Mesh& mesh, Half half);

/// True when the edge is unconstrained and the apex beyond it lies strictly inside this side's circumcircle (exact).
bool flipWanted(const Mesh& mesh, Half half);

/// One flip: the diagonal that vanished and the one that came, as vertices, so that it can be undone.
struct Flip {
  Vertex a, b;  // old diagonal
  Vertex c, d;  // new diagonal
};

/// Flips that one change of a mesh may call for. It takes a handful where the mesh was Delaunay before; only signs that
/// are wrong, of determinants too small for a double, could ask for them without end.
inline std::size_t mostFlips(const Mesh& mesh) { return 64 + mesh.triangles.size(); }

/// Calls flip(half), which makes the flip and returns its diagonal, for each edge that wants to be flipped among the
/// suspects, the last one first, and the edges around what was flipped. False when more than mostFlips() are wanted.
template <class Flip>
bool flipWhileWanted(const Mesh& mesh, std::vector<Half>& suspects, const Flip& flip) {
  const std::size_t most = mostFlips(mesh);
  for (std::size_t flips = 0; !suspects.empty();) {
    const Half half = suspects.back();
    suspects.pop_back();
    if (!flipWanted(mesh, half)) continue;
    if (flips++ == most) return false;
    const Half diagonal = flip(half);
    for (const Half side : {diagonal, oppositeOf(mesh, diagonal)})
      for (const int corner : {next3(cornerOf(side)), prev3(cornerOf(side))})
        suspects.push_back(halfOf(triangleOf(side), corner));
  }
  return true;
}

/// Flips until the edges on and around the given half-edges' triangles are locally Delaunay, or `most` have been made.
/// Appends each flip.
void restoreDelaunay(Mesh& mesh, std::vector<Half>& suspects, std::vector<Flip>& done, std::size_t most);

}  // namespace triscope
