// Density boxes hold in every cell that they reach, however large they are, and are one wish each.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/density/sources.h"
#include "support/random.h"
#include "support/runs.h"

namespace triscope::density_box_test {
namespace {

std::string squareWith(const std::string& density) {
  return R"({"outer": [[0, 0], [10, 0], [10, 10], [0, 10]], "min_edge_length": 0.1, "density": [)" + density + "]}";
}

// Ignored, and half a gigabyte of wishes, when the wishes were a grid over all of the box.
TEST(DensityBox, CountsWithinTheDomainOnly) {
  const struct {
    const char* file;
    const char* within;
  } cases[] = {{"box_larger_than_domain.json", R"({"box": [[0, 0], [10, 10]], "length": 0.2})"},
               {"box_strip_beyond_domain.json", R"({"box": [[2, 2], [4, 10]], "length": 0.2})"}};
  for (const auto& c : cases) {
    const MeshState beyond = support::after(support::domainAt(support::testData() / c.file), Stage::density);
    const MeshState within = support::after(support::domainFrom(squareWith(c.within)), Stage::density);
    EXPECT_EQ(hashOf(beyond), hashOf(within)) << c.file;
    EXPECT_LT(beyond.constraints.size(), 100u) << c.file;
    const Box box = boxOf(beyond.domain->density[0], *beyond.domain);
    for (int k = 0; k <= 400; ++k) {
      const Point p = box.lo + Point{box.width() * (k % 21) / 20.0, box.height() * (k / 21) / 20.0};
      EXPECT_LE(edgeLengthAt(beyond.tree, p), 0.2 * (1 + 1e-9)) << c.file;
    }
  }
}

// What a grid of points asks for that is fine enough to reach every cell.
TEST(DensityBox, IsAsManyPoints) {
  support::Random random(7);
  for (int round = 0; round < 20; ++round) {
    const Point lo{random.between(0.0, 6.0), random.between(0.0, 6.0)};
    const Point size{random.between(0.1, 4.0), random.between(0.1, 4.0)};
    const double length = random.between(0.1, 1.0);
    std::string points;
    const int nx = static_cast<int>(size.x / (2.0 * length)) + 1;
    const int ny = static_cast<int>(size.y / (2.0 * length)) + 1;
    for (int j = 0; j <= ny; ++j)
      for (int i = 0; i <= nx; ++i)
        points += fmt::format(R"({}{{"at": [{}, {}], "length": {}}})", points.empty() ? "" : ", ",
                              lo.x + size.x * i / nx, lo.y + size.y * j / ny, length);
    const std::string box = fmt::format(R"({{"box": [[{}, {}], [{}, {}]], "length": {}}})", lo.x, lo.y, lo.x + size.x,
                                        lo.y + size.y, length);
    const MeshState a = support::after(support::domainFrom(squareWith(box)), Stage::density);
    const MeshState b = support::after(support::domainFrom(squareWith(points)), Stage::density);
    EXPECT_EQ(a.tree.cells.size(), b.tree.cells.size()) << box;
    for (int k = 0; k < 500; ++k) {
      const Point p{random.between(0.0, 10.0), random.between(0.0, 10.0)};
      EXPECT_EQ(densityRankAt(a.tree, p), densityRankAt(b.tree, p)) << box << " at " << p.x << ", " << p.y;
    }
  }
}

TEST(DensityBox, IsOneWish) {
  const MeshState state = support::after(support::domainFrom(squareWith(R"({"box": [[1, 1], [3, 5]], "length": 0.2})")),
                                         Stage::constraints);
  EXPECT_EQ(std::ranges::count(state.constraints, Rule::user_request, &Constraint::source), 1);
  EXPECT_EQ(state.constraints[0].at, (Point{2, 3}));
}

}  // namespace
}  // namespace triscope::density_box_test
