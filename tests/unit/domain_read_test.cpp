// What a domain file means: curves, orientation, names, density.
#include "core/domain/read.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "core/domain/check.h"
#include "core/domain/outline.h"
#include "core/geometry/trig.h"

namespace triscope::domain_read_test {
namespace {

Domain parse(std::string_view json) {
  auto domain = parseDomain(json, "folder/plate.json");
  EXPECT_TRUE(domain.ok()) << describe(domain.error());
  return domain ? *domain : Domain{};
}

/// Twice the area that a loop encloses, positive counter-clockwise.
double doubleArea(const Domain& domain, std::uint32_t loop) {
  double sum = 0.0;
  for (const Chord& chord : outlineOf(domain, loop)) sum += cross(chord.a, chord.b);
  return sum;
}

std::vector<Point> startsOf(const Domain& domain, std::uint32_t loop) {
  std::vector<Point> starts;
  const Loop& run = domain.loops[loop];
  for (std::uint32_t i = 0; i < run.curveCount; ++i) starts.push_back(domain.curves[run.firstCurve + i].a);
  return starts;
}

TEST(DomainRead, PolygonVerticesAreKeptBitForBit) {
  const Domain domain = parse(R"({"outer": [[0.1, 0.2], [7.3, -1e-9], [3.000000000000001, 5]], "note": 1})");
  ASSERT_EQ(domain.loops.size(), 1u);
  EXPECT_EQ(startsOf(domain, 0), (std::vector<Point>{{0.1, 0.2}, {7.3, -1e-9}, {3.000000000000001, 5}}));
  for (const Curve& curve : domain.curves) EXPECT_EQ(curve.kind, CurveKind::line);
  EXPECT_EQ(domain.curves[2].b, domain.curves[0].a);
}

TEST(DomainRead, ARepeatedLastPointCloses) {
  const Domain open = parse(R"({"outer": [[0,0],[4,0],[0,4]], "holes": [[[1,1],[2,1],[1,2]]]})");
  const Domain closed = parse(R"({"outer": [[0,0],[4,0],[0,4],[0,0]], "holes": [[[1,1],[2,1],[1,2],[1,1]]]})");
  EXPECT_EQ(startsOf(open, 0), startsOf(closed, 0));
  EXPECT_EQ(startsOf(open, 1), startsOf(closed, 1));
}

TEST(DomainRead, EitherOrientationComesOutTheSameWayRound) {
  const std::string outers[] = {"[[0,0],[9,0],[9,9],[0,9]]", "[[0,9],[9,9],[9,0],[0,0]]"};
  const std::string holes[] = {"[[1,1],[2,1],[1,2]]", "[[1,2],[2,1],[1,1]]"};
  for (const auto& outer : outers) {
    for (const auto& hole : holes) {
      const Domain domain = parse(R"({"outer": )" + outer + R"(, "holes": [)" + hole + "]}");
      EXPECT_EQ(doubleArea(domain, 0), 162.0);
      EXPECT_EQ(doubleArea(domain, 1), -1.0);
      EXPECT_EQ(domain.loops[0].role, LoopRole::outer);
      EXPECT_EQ(domain.loops[1].role, LoopRole::hole);
    }
  }
}

TEST(DomainRead, CurvedLoopsAreTurnedRoundToo) {
  const Domain domain = parse(R"({
    "outer": {"kind": "circle", "centre": [0, 0], "radius": 8},
    "holes": [{"kind": "circle", "centre": [3, 0], "radius": 1},
              {"kind": "spline", "points": [[-3,-1],[-2,0],[-3,1],[-4,0]]},
              {"pieces": [{"points": [[0,3],[0,4]]}, {"kind": "arc", "points": [[0,4],[0.5,3.5],[0,3]]}]}]})");
  EXPECT_NEAR(doubleArea(domain, 0), 128.0 * trig::kPi, 0.05);
  EXPECT_NEAR(doubleArea(domain, 1), -2.0 * trig::kPi, 0.001);
  EXPECT_LT(doubleArea(domain, 2), -4.0);
  EXPECT_NEAR(doubleArea(domain, 3), -0.25 * trig::kPi, 0.001);
  for (std::uint32_t i = 0; i < domain.loops.size(); ++i) {
    const std::vector<Chord> chords = outlineOf(domain, i);
    for (std::size_t k = 0; k < chords.size(); ++k) EXPECT_EQ(chords[k].b, chords[(k + 1) % chords.size()].a);
  }
}

TEST(DomainRead, MessagesNumberTheFileNotTheTurnedLoop) {
  // The same crossing hole, given both ways round: the message must follow the file.
  const auto one = parseDomain(R"({"outer": [[0,0],[9,0],[9,9],[0,9]], "holes": [[[5,5],[6,10],[4,6]]]})", "");
  const auto other = parseDomain(R"({"outer": [[0,9],[9,9],[9,0],[0,0]], "holes": [[[4,6],[6,10],[5,5]]]})", "");
  ASSERT_FALSE(one.ok());
  ASSERT_FALSE(other.ok());
  EXPECT_EQ(one.error().message, "edge 1-2 crosses edge 2-3 of loop 'outer'");
  EXPECT_EQ(other.error().message, "edge 0-1 crosses edge 0-1 of loop 'outer'");
  EXPECT_EQ(one.error().at, other.error().at);
}

TEST(DomainRead, NamesAreGivenOrCounted) {
  const Domain domain = parse(R"({
    "outer": {"name": "tank", "points": [[0,0],[9,0],[9,9],[0,9]]},
    "holes": [[[1,1],[2,1],[1,2]], {"name": "rod", "kind": "circle", "centre": [5,5], "radius": 1}, [[7,7],[8,7],[7,8]]],
    "segments": [[[3,1],[4,1]]]})");
  std::vector<std::string> names;
  for (const Loop& loop : domain.loops) names.push_back(loop.name);
  EXPECT_EQ(names, (std::vector<std::string>{"tank", "hole 1", "rod", "hole 3", "segment 1"}));
  EXPECT_EQ(domain.name, "plate");
  EXPECT_EQ(domain.file, "folder/plate.json");
  EXPECT_EQ(parse(R"({"name": "Grüße", "outer": [[0,0],[4,0],[0,4]]})").name, "Grüße");
}

TEST(DomainRead, BoundsHoldTheCurvesNotOnlyTheirPoints) {
  const Domain domain = parse(R"({"outer": {"kind": "circle", "centre": [1, 2], "radius": 3}})");
  EXPECT_NEAR(domain.bounds.lo.x, -2.0, 1e-12);
  EXPECT_NEAR(domain.bounds.lo.y, -1.0, 1e-12);
  EXPECT_EQ(domain.bounds.hi.x, 4.0);
  EXPECT_NEAR(domain.bounds.hi.y, 5.0, 1e-12);
}

TEST(DomainRead, TheCentreMayBeSpeltCenter) {
  const Domain domain = parse(R"({"outer": {"kind": "circle", "center": [1, 2], "radius": 3}})");
  const Domain same = parse(R"({"outer": {"kind": "circle", "centre": [1, 2], "radius": 3}})");
  EXPECT_EQ(domain.curves[0].centre, same.curves[0].centre);
  EXPECT_EQ(domain.curves[0].radius, same.curves[0].radius);
}

TEST(DomainRead, SplinesAreSplitAtTheirCorners) {
  const std::string points = R"("points": [[0,0],[3,-0.3],[6,0],[6,3],[6,6],[3,6.3],[0,6],[0,3]])";
  const auto curvesWith = [&](const std::string& corners) {
    return parse(R"({"outer": {"kind": "spline", )" + corners + points + "}}").curves;
  };
  const auto smooth = curvesWith("");
  ASSERT_EQ(smooth.size(), 1u);
  EXPECT_EQ(smooth[0].a, smooth[0].b);
  EXPECT_EQ(smooth[0].knots.size(), 9u);

  const auto listed = curvesWith(R"("corners": [6, 2], )");
  ASSERT_EQ(listed.size(), 2u);
  EXPECT_EQ(listed[0].a, (Point{6, 0}));
  EXPECT_EQ(listed[0].b, (Point{0, 6}));
  EXPECT_EQ(listed[1].b, (Point{6, 0}));

  const auto turning = curvesWith(R"("corner_turn": 70, )");
  ASSERT_EQ(turning.size(), 4u);
  for (const Curve& curve : turning) EXPECT_EQ(curve.knots.size(), 3u);

  const auto one = curvesWith(R"("corners": [4], )");
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one[0].a, (Point{6, 6}));
  EXPECT_EQ(one[0].b, (Point{6, 6}));

  const auto both = curvesWith(R"("corners": [1], "corner_turn": 70, )");
  ASSERT_EQ(both.size(), 5u);
  EXPECT_EQ(both[0].kind, CurveKind::line);  // from one point to the next
}

TEST(DomainRead, PiecesFollowOneAnother) {
  const Domain domain = parse(R"({"outer": {"pieces": [
      {"kind": "line", "points": [[0,0],[4,0],[4,2]]},
      {"kind": "arc", "points": [[4,2],[2,4],[0,2]]},
      {"kind": "spline", "points": [[0,2],[-0.3,1],[0,0]]}]}})");
  ASSERT_EQ(domain.curves.size(), 4u);
  EXPECT_EQ(domain.curves[2].kind, CurveKind::arc);
  EXPECT_EQ(domain.curves[3].kind, CurveKind::spline);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(domain.curves[i].b, domain.curves[(i + 1) % 4].a);
}

TEST(DomainRead, SegmentsMayBranchAndStartOnTheBoundary) {
  const Domain domain = parse(R"({
    "outer": [[0,0],[4,0],[4,4],[0,4],[0,2]],
    "holes": [[[2,1],[3,1],[3,2]]],
    "segments": [[[0,2],[1,2],[2,3]], [[1,2],[1,1]], [[1,2],[1,3],[2,3]], [[2,1],[1,1]], [[3,1],[4,0]]]})");
  EXPECT_EQ(domain.loops.size(), 7u);
  EXPECT_EQ(domain.loops[2].role, LoopRole::chain);
  EXPECT_EQ(startsOf(domain, 2), (std::vector<Point>{{0, 2}, {1, 2}}));
}

TEST(DomainRead, SegmentsMayBeSplinesPiecesAndClosed) {
  const Domain domain = parse(R"({
    "outer": [[0,0],[8,0],[8,8],[0,8]],
    "segments": [{"kind": "spline", "points": [[1,1],[2,2],[3,1],[4,2]], "corners": [2]}, [[3,1],[3,4]],
                 {"pieces": [{"kind": "arc", "points": [[5,5],[6,6],[7,5]]}, {"points": [[7,5],[5,5]]}]}]})");
  EXPECT_EQ(domain.loops[1].curveCount, 2u);
  EXPECT_EQ(domain.loops[3].curveCount, 2u);
}

TEST(DomainRead, ASplineIsJudgedByItsCurveNotByItsPolygon) {
  // Outside the polygon through the points, inside the curve.
  const Domain domain = parse(R"({"outer": {"kind": "spline", "points": [[0,0],[4,0],[4,4],[0,4]]},
                                  "holes": [{"kind": "circle", "centre": [4.3, 2], "radius": 0.1}]})");
  EXPECT_EQ(domain.loops.size(), 2u);
}

TEST(DomainRead, DensityOfEveryKind) {
  const Domain domain = parse(R"({
    "outer": {"name": "tank", "points": [[0,0],[9,0],[9,9],[0,9]]}, "min_edge_length": 0.25,
    "density": [{"name": "tip", "at": [1,2], "rank": 3}, {"loop": "tank", "length": 0.5},
                {"box": [[7,8],[5,2]], "length": 0.25}]})");
  EXPECT_EQ(domain.minEdgeLength, 0.25);
  ASSERT_EQ(domain.density.size(), 3u);
  EXPECT_EQ(domain.density[0].name, "tip");
  EXPECT_EQ(domain.density[0].where, DensityRequest::Where::point);
  EXPECT_EQ(domain.density[0].at, (Point{1, 2}));
  EXPECT_EQ(domain.density[0].rank, 3);
  EXPECT_EQ(domain.density[0].length, 0.0);
  EXPECT_EQ(domain.density[1].where, DensityRequest::Where::loop);
  EXPECT_EQ(domain.density[1].loop, "tank");
  EXPECT_EQ(domain.density[1].length, 0.5);
  EXPECT_EQ(domain.density[1].rank, 0);
  EXPECT_EQ(domain.density[2].where, DensityRequest::Where::box);
  EXPECT_EQ(domain.density[2].at, (Point{5, 2}));  // corners in any order
  EXPECT_EQ(domain.density[2].to, (Point{7, 8}));
}

TEST(DomainRead, UnknownKeysAtTheTopAreTheAuthorsOwn) {
  const Domain domain = parse(R"({"outer": [[0,0],[4,0],[0,4]], "stats": {"points": [1]}, "note": null, "kind": "x"})");
  EXPECT_EQ(domain.minEdgeLength, 0.0);
}

TEST(DomainRead, ADomainMadeInMemoryIsCheckedTheSameWay) {
  Domain square;
  const Point corners[] = {{0, 0}, {0, 1}, {1, 1}, {1, 0}};  // clockwise
  for (std::size_t i = 0; i < 4; ++i) square.curves.push_back({.a = corners[i], .b = corners[(i + 1) % 4]});
  square.loops.push_back({"square", LoopRole::outer, 0, 4});
  const auto checked = checkDomain(square);
  ASSERT_TRUE(checked.ok()) << describe(checked.error());
  EXPECT_EQ(doubleArea(*checked, 0), 2.0);
  EXPECT_EQ(checked->bounds.hi, (Point{1, 1}));

  std::swap(square.curves[1].b, square.curves[2].b);
  square.curves[2].a = square.curves[1].b;
  square.curves[3].a = square.curves[2].b;
  const auto crossed = checkDomain(square);
  ASSERT_FALSE(crossed.ok());
  EXPECT_EQ(crossed.error().loop, "square");
}

}  // namespace
}  // namespace triscope::domain_read_test
