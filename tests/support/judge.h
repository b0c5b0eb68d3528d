// What every finished mesh is held to: the bounds of section 3, its domain, and the rules of a triangulation.
#pragma once

#include "core/method/state.h"

namespace triscope::support {

/// Section 3: aspect < 4.31, area ratio < 3, edge ratio < 2, all angles in (30°, 120°).
void expectBounds(const MeshState& state);

/// `validate` has nothing to report, and every triangle is counter-clockwise and exactly Delaunay across every edge
/// that is not on the boundary.
void expectValid(const Mesh& mesh);

/// Every kept point is a vertex, bit for bit; every curve is followed from end to end by edges of the mesh with the
/// domain on their left; nothing else is a border; the area is the polygon's where every curve is a line, to 1e-12 or
/// the larger part of it given.
void expectFollowsDomain(const MeshState& state, double areaTolerance = 1e-12);

/// No edge is shorter than that part of a Δx that was given, or of a shorter one that the domain itself asks for.
void expectNoShortEdge(const MeshState& state, double part = 1.0);

/// Area of the mesh, and of the domain when its curves are lines, in extended precision about the domain's corner.
long double areaOf(const MeshState& state);
long double areaOf(const Domain& domain);

/// Shortest edge that the domain itself may ask for: a straight piece between two kept points, one of the six edges
/// that a smooth closed curve has at least, or one across the narrowest place between two curves that do not touch.
double shortestUnavoidableEdge(const Domain& domain);

}  // namespace triscope::support
