#include "core/optimise/smooth.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/optimise/penalty.h"
#include "support/meshes.h"
#include "support/random.h"

namespace triscope::smooth_test {
namespace {

using support::Random;

/// A closed star of `count` triangles about the origin, its rim at irregular distances around 1.
Ring starAround(Random& random, int count) {
  Ring ring;
  ring.count = count;
  ring.closed = true;
  for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
    const double angle = 2.0 * 3.14159265358979 * (static_cast<double>(k) + random.between(-0.2, 0.2)) / count;
    ring.at[k] = random.between(0.8, 1.25) * Point{std::cos(angle), std::sin(angle)};
    ring.sizes[k] = random.between(0.9, 1.1);
  }
  ring.at[static_cast<std::size_t>(count)] = ring.at[0];
  ring.sizes[static_cast<std::size_t>(count)] = ring.sizes[0];
  return ring;
}

double sumOfShapes(const Ring& ring, Point hub, double size) {
  double sum = 0.0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(ring.count); ++k) {
    const double wanted = (size + ring.sizes[k] + ring.sizes[k + 1]) / 3.0;
    const double edges = squaredDistance(hub, ring.at[k]) + squaredDistance(hub, ring.at[k + 1]) +
                         squaredDistance(ring.at[k], ring.at[k + 1]);
    sum += (edges + 0.5 * std::sqrt(0.75) * wanted * wanted) / fanArea(ring, static_cast<int>(k), hub);
  }
  return sum;
}

TEST(Smooth, LeavesTheMiddleOfARegularStarAlone) {
  Ring ring;
  ring.count = 6;
  ring.closed = true;
  for (std::size_t k = 0; k <= 6; ++k) {
    const double angle = 3.14159265358979 / 3.0 * static_cast<double>(k);
    ring.at[k] = {std::cos(angle), std::sin(angle)};
    ring.sizes[k] = 1.0;
  }
  EXPECT_EQ(meanOfCircumcentres(ring, {0, 0}, 1.0).kind, StepKind::still);
  EXPECT_EQ(towardBestShape(ring, {0, 0}, 1.0).kind, StepKind::still);
  for (const auto rule : {meanOfCircumcentres, towardBestShape}) {
    const SmoothStep back = rule(ring, {0.15, -0.1}, 1.0);
    ASSERT_EQ(back.kind, StepKind::moves);
    EXPECT_LT(length(back.to), 0.06) << "most of the way to the middle";
    EXPECT_TRUE(back.wakes);
  }
}

TEST(Smooth, BestShapeLowersTheSumThatItIsAStepOf) {
  Random random{17};
  int moved = 0;
  for (int k = 0; k < 400; ++k) {
    const Ring ring = starAround(random, 4 + static_cast<int>(random.below(5)));
    const Point hub{random.between(-0.3, 0.3), random.between(-0.3, 0.3)};
    const SmoothStep step = towardBestShape(ring, hub, 1.0);
    if (step.kind != StepKind::moves) continue;
    ++moved;
    EXPECT_LT(sumOfShapes(ring, step.to, 1.0), sumOfShapes(ring, hub, 1.0) + 1e-9);
  }
  EXPECT_GT(moved, 200);
}

TEST(Smooth, RefusesWhatWouldBeThin) {
  // Rims with deep notches: there is little room that sees all of them.
  Random random{23};
  int refused = 0, moved = 0;
  for (int k = 0; k < 4000; ++k) {
    Ring ring = starAround(random, 5 + static_cast<int>(random.below(4)));
    for (std::size_t n = 0; n < static_cast<std::size_t>(ring.count); n += 2) ring.at[n] = 0.15 * ring.at[n];
    ring.at[static_cast<std::size_t>(ring.count)] = ring.at[0];
    const Point hub{random.between(-0.05, 0.05), random.between(-0.05, 0.05)};
    for (const auto rule : {meanOfCircumcentres, towardBestShape}) {
      const SmoothStep step = rule(ring, hub, 1.0);
      refused += step.kind == StepKind::refused ? 1 : 0;
      if (step.kind != StepKind::moves) continue;
      ++moved;
      for (int n = 0; n < ring.count; ++n) EXPECT_GT(fanArea(ring, n, step.to), 0.0);
    }
  }
  EXPECT_GT(refused, 0);
  EXPECT_GT(moved, 0);
}

TEST(Penalty, SlopeIsThatOfTheSum) {
  Random random{29};
  const PenaltyLimits limits = limitsFor({50.0, 70.0, 1.1, 1.1});  // so tight that every part counts
  int looked = 0;
  for (int k = 0; k < 200; ++k) {
    // A hub in the box of a triangulation: its star and the triangles beyond are there.
    Mesh mesh = support::triangulationOf(support::randomPoints(random, 30, {0, 0}, {1, 1}));
    const Vertex hub(4 + random.below(mesh.points.size() - 4));
    Sizes sizes(mesh.points.size(), 0.0);
    for (double& size : sizes) size = random.between(0.1, 0.4);
    Ring ring;
    ASSERT_TRUE(gatherRing(mesh, sizes, hub, ring));
    if (!ring.closed) continue;
    StarPenalty penalty(mesh, ring, sizes[hub], limits);
    const Point at = pointOf(mesh, hub);
    const double here = penalty.withSlopeAt(at);
    if (here > 1e3) continue;  // as good as turned over
    ++looked;
    const Point slope = penalty.slope;
    EXPECT_EQ(penalty.at(at), here);
    const double step = 1e-7;
    const double dx = (penalty.at(at + Point{step, 0}) - penalty.at(at - Point{step, 0})) / (2 * step);
    const double dy = (penalty.at(at + Point{0, step}) - penalty.at(at - Point{0, step})) / (2 * step);
    // The slope is that of half the sum of squares.
    const double scale = 1e-3 * (std::fabs(dx) + std::fabs(dy)) + 1e-4;
    EXPECT_NEAR(2 * slope.x, dx, scale);
    EXPECT_NEAR(2 * slope.y, dy, scale);
  }
  EXPECT_GT(looked, 50);
}

TEST(Penalty, IsNothingForEquilateralTrianglesOfTheSizeWanted) {
  const double height = std::sqrt(0.75);
  const Mesh mesh = support::meshOf({{0, 0}, {1, 0}, {0.5, height}, {1.5, height}}, {{0, 1, 2}, {1, 3, 2}});
  const Sizes sizes(4, 1.0);
  const PenaltyLimits limits = limitsFor(aimsOf({}));
  for (const Slot slot : support::liveSlots(mesh)) EXPECT_EQ(penaltyOf(mesh, sizes, slot, limits), 0.0);
  const Sizes small(4, 0.5);
  for (const Slot slot : support::liveSlots(mesh)) {
    EXPECT_GT(penaltyOf(mesh, small, slot, limits), 0.0) << "edges twice as long as wanted";
    EXPECT_EQ(penaltyOf(mesh, small, slot, slackFor(aimsOf({}))), 0.0) << "nothing is edited for a length";
  }
}

TEST(Penalty, SaysBadWhereAnAimIsBroken) {
  // Angles 90, 53 and 37; a pair with areas 3 to 1.
  const Mesh mesh = support::meshOf({{0, 0}, {3, 0}, {0, 4}, {1.5, -1.2}}, {{0, 1, 2}, {1, 0, 3}});
  Sizes sizes(4, 3.0);
  const auto of = [&](Slot slot, Aims aims) {
    PenaltyLimits limits = limitsFor(aims);
    limits.shortest = 0.0;
    limits.longest = 1e300;
    return penaltyOf(mesh, sizes, slot, limits);
  };
  EXPECT_EQ(of(Slot(0), {30.0, 95.0, 5.0, 2.0}), 0.0);
  EXPECT_GT(of(Slot(0), {40.0, 95.0, 5.0, 2.0}), 0.0) << "lowest angle";
  EXPECT_GT(of(Slot(0), {30.0, 89.0, 5.0, 2.0}), 0.0) << "highest angle";
  EXPECT_GT(of(Slot(0), {30.0, 95.0, 3.0, 2.0}), 0.0) << "area ratio";
  EXPECT_GT(of(Slot(0), {30.0, 95.0, 5.0, 1.6}), 0.0) << "edge ratio";
}

}  // namespace
}  // namespace triscope::smooth_test
