// Where a vertex inside the domain is to go, by its star alone: one step of two kinds of smoothing.
#pragma once

#include "core/optimise/ring.h"

namespace triscope {

/// Of an equilateral triangle: twice the area over the squared edge.
inline constexpr double kEquilateral = 0.8660254037844386;

enum class StepKind : std::uint8_t {
  still,    // the place is not worth moving to
  moves,    // to `to`, where every triangle of the star keeps its floor
  refused,  // a triangle would become too thin, even a quarter of the way
};

struct SmoothStep {
  StepKind kind = StepKind::still;
  Point to;
  bool wakes = false;  // the way is long enough for the neighbours to be looked at again
};

/// To the mean of the circumcentres of the star, weighted by area over the fourth power of the edge length wanted: one
/// step of optimal Delaunay triangulation (L. Chen and J. Xu, 2004; P. Alliez et al., 2005) for a graded density. The
/// ring is closed.
SmoothStep meanOfCircumcentres(const Ring& ring, Point hub, double size);

/// One Newton step on the sum over the star of (a² + b² + c² + S*/2) / S, a, b, c the edges of a triangle, S twice its
/// area and S* that of an equilateral one of the size wanted. The sum is convex in the hub's place as long as no
/// triangle turns over: quadratic over linear. The ring is closed.
SmoothStep towardBestShape(const Ring& ring, Point hub, double size);

}  // namespace triscope
