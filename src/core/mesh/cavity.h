// Bowyer-Watson insertion in two halves: find the cavity (changes nothing), then fill it.
#pragma once

#include "core/mesh/mesh.h"

namespace triscope {

/// The connected triangles whose circumcircle holds a point, not reaching through constrained edges.
struct Cavity {
  std::vector<std::int32_t> triangles;  // slots; the first is where the search began
  std::vector<std::int32_t> rim;        // half-edges of cavity triangles, counter-clockwise around the point
};

/// Begins at `start`, which must hold p in its closure or in its circumcircle.
void findCavity(Mesh& mesh, Point p, std::int32_t start, Cavity& cavity);

/// Same, for a point that splits the constrained half-edge `edge`: the rim leaves out that edge, on both sides when
/// the edge is an inner one. Returns false, with an empty cavity, when p does not see the whole rim.
bool findSplitCavity(Mesh& mesh, Point p, std::int32_t edge, Cavity& cavity);

/// Replaces the cavity by triangles from its rim to a new vertex. The new triangles have consecutive ids.
std::int32_t fillCavity(Mesh& mesh, const Cavity& cavity, Point p, VertexKind kind, std::uint8_t density);

/// Same for the cavity of a split: boundary edge `edge` of Mesh::edges is split at curve parameter t.
std::int32_t fillSplitCavity(Mesh& mesh, const Cavity& cavity, Point p, std::int32_t edge, double t,
                             std::uint8_t density);

/// Shortest distance² from p to a rim vertex: the nearest vertex that p sees.
double nearestSquaredDistance(const Mesh& mesh, const Cavity& cavity, Point p);

}  // namespace triscope
