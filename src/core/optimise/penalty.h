// How far triangles are beyond what is aimed at: 0 where nothing is, and smooth beyond, so that a vertex can be led
// back.
#pragma once

#include "core/optimise/ring.h"
#include "core/words/settings.h"

namespace triscope {

/// The aims as the penalty takes them: angles by their cotangents, which need no root.
struct PenaltyLimits {
  double mostCotangent = 0.0;   // of the lowest angle
  double leastCotangent = 0.0;  // of the highest
  double lowWeight = 1.0;       // squared sine of the lowest: makes both excesses radians
  double squaredEdgeRatio = 0.0;
  double areaRatio = 0.0;
  double shortest = 0.0;  // edge over the length wanted, squared
  double longest = 1e300;
};

/// The aims themselves.
PenaltyLimits limitsFor(const Aims& aims);
/// A little beyond the aims: so far a mesh counts as one that keeps to them.
Aims withSlack(const Aims& aims);
/// Of those: what is worse than this is worth an edit. Lengths count for nothing.
PenaltyLimits slackFor(const Aims& aims);

/// Of a live triangle with its edges, each shared one by half, and the pairs that it is in, by half.
double penaltyOf(const Mesh& mesh, const Sizes& sizes, Slot slot, const PenaltyLimits& limits);

/// Of a star with its hub wherever it may be put, and how the penalty changes there.
class StarPenalty {
 public:
  StarPenalty(const Mesh& mesh, const Ring& ring, double hubSize, const PenaltyLimits& limits);

  /// 1e30 where a triangle turns over.
  double at(Point hub);
  /// The same, with slope and curvature (Gauss-Newton) in the members below.
  double withSlopeAt(Point hub);

  Point slope;
  double xx = 0.0, xy = 0.0, yy = 0.0;
  bool obtuse = false;  // an angle of the star, at the last place asked about, is

 private:
  template <bool withSlope>
  double sum(Point hub);
  template <bool withSlope>
  double triangles(Point hub);
  template <bool withSlope>
  double lengths(Point hub);
  template <bool withSlope>
  double pairs();
  void add(double residual, Point change);

  const Ring& ring_;
  const PenaltyLimits& limits_;
  std::array<double, Ring::kMost> beyond_;      // twice the area across each rim edge, 0 at a border
  std::array<double, Ring::kMost + 1> wanted_;  // length of each spoke
  std::array<double, Ring::kMost> area_;        // twice, of each triangle
  std::array<Point, Ring::kMost> areaSlope_;
};

}  // namespace triscope
