// The density stage: Table 1 in every cell, ranks that differ by one at most, cell types, the estimate.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/density/boundary_tree.h"
#include "core/density/classify.h"
#include "support/random.h"
#include "support/runs.h"
#include "support/watch.h"

namespace triscope::density_test {
namespace {

const Cell& cellAt(const Quadtree& tree, std::int32_t index) { return tree.cells[static_cast<std::size_t>(index)]; }

template <class Look>
void eachLeaf(const Quadtree& tree, Look look) {
  for (std::size_t k = 0; k < tree.cells.size(); ++k) {
    if (tree.cells[k].child < 0) look(static_cast<std::int32_t>(k), tree.cells[k]);
  }
}

class Density : public testing::TestWithParam<const char*> {
 protected:
  MeshState state = support::after(support::domainFrom(GetParam()), Stage::density);
};

INSTANTIATE_TEST_SUITE_P(Domains, Density,
                         testing::Values(support::kFrame, support::kCrackedFrame, support::kRound, support::kNotched));

TEST_P(Density, EveryCellHoldsARankThatTable1Allows) {
  eachLeaf(state.tree, [&](std::int32_t leaf, const Cell& cell) {
    EXPECT_GE(cell.density, 1) << "cell " << leaf;
    EXPECT_LE(cell.rank, largestCellRank(cell.density)) << "cell " << leaf << " is too large for its density";
    EXPECT_LE(cell.density, std::min(state.settings.maxRank, 3 * state.tree.cells[0].rank)) << "cell " << leaf;
  });
}

TEST_P(Density, NeighboursDifferByOneRankAtMost) {
  std::vector<std::int32_t> around;
  eachLeaf(state.tree, [&](std::int32_t leaf, const Cell& cell) {
    neighboursOf(state.tree, leaf, around);
    for (const std::int32_t other : around) {
      EXPECT_LE(std::abs(cell.density - cellAt(state.tree, other).density), 1) << "cells " << leaf << ", " << other;
      EXPECT_LE(std::abs(cell.rank - cellAt(state.tree, other).rank), 1) << "cells " << leaf << ", " << other;
    }
  });
}

TEST_P(Density, KeepsEveryConstraint) {
  for (const Constraint& constraint : state.constraints) {
    EXPECT_LE(edgeLengthAt(state.tree, constraint.at), std::max(constraint.length, state.tree.minEdge) * (1.0 + 1e-9));
  }
}

// A cell touched by a piece of the boundary is a boundary cell; the others lie on one side as a whole.
TEST_P(Density, ClassifiesEveryCell) {
  const BoundaryTree boundary = boundaryTreeOf(*state.domain, 0.02);
  std::vector<std::uint8_t> touched(state.tree.cells.size(), 0);
  for (const BoundaryPiece& piece : boundary.pieces) {
    for (int k = 0; k <= 400; ++k) {
      touched[static_cast<std::size_t>(leafAt(state.tree, piece.a + (k / 400.0) * (piece.b - piece.a)))] = 1;
    }
  }
  std::vector<std::int32_t> around;
  eachLeaf(state.tree, [&](std::int32_t leaf, const Cell& cell) {
    if (touched[static_cast<std::size_t>(leaf)] != 0) {
      EXPECT_EQ(cell.type, CellType::boundary) << "cell " << leaf;
    }
    if (cell.type == CellType::boundary) return;
    const double half = 0.5 * state.tree.side(cell);
    const bool inside = insideDomain(boundary, state.tree.corner(cell) + Point{half, half});
    EXPECT_EQ(cell.type == CellType::outside, !inside) << "cell " << leaf;
    if (!inside) return;
    neighboursOf(state.tree, leaf, around);
    const bool adjacent = std::ranges::any_of(
        around, [&](std::int32_t other) { return cellAt(state.tree, other).type == CellType::boundary; });
    EXPECT_EQ(cell.type == CellType::adjacent_boundary, adjacent) << "cell " << leaf;
  });
}

TEST_P(Density, EstimatesFromTable1) {
  // Every cell in full bounds the estimate from above, inner cells alone from below.
  double all = 0.0, inner = 0.0;
  eachLeaf(state.tree, [&](std::int32_t, const Cell& cell) {
    if (cell.type == CellType::outside) return;
    all += trianglesInCell(cell.rank, cell.density);
    if (cell.type != CellType::boundary) inner += trianglesInCell(cell.rank, cell.density);
  });
  EXPECT_GT(state.estimatedTriangles, inner);
  EXPECT_LT(state.estimatedTriangles, all);
}

TEST_P(Density, EventsSayWhatBecameOfEachCell) {
  MeshState fresh = support::start(support::domainFrom(GetParam()));
  support::eachDecision(fresh, Stage::density, [](const MeshState& before, const MeshState& now, auto events) {
    if (now.stage < Stage::quadtree || events.empty()) return;
    if (events.front().stage != Stage::quadtree && events.front().stage != Stage::density) return;
    ASSERT_EQ(events.size(), 1u);
    const Event& event = events.front();
    const auto subject = static_cast<std::int32_t>(event.subject);
    ASSERT_LT(event.subject, before.tree.cells.size());
    const Cell& was = cellAt(before.tree, subject);
    const Cell& is = cellAt(now.tree, subject);
    EXPECT_EQ(was.child, -1) << "cell " << subject << " was split before";
    if (event.kind == EventKind::cell_split) {
      EXPECT_EQ(event.created, before.tree.cells.size());
      EXPECT_EQ(event.createdCount, 4u);
      EXPECT_EQ(is.child, static_cast<std::int32_t>(event.created));
      EXPECT_EQ(now.tree.cells.size(), before.tree.cells.size() + 4);
      EXPECT_EQ(event.measured, was.rank);
      EXPECT_GT(event.measured, event.limit) << "it was small enough already";
    } else {
      ASSERT_EQ(event.kind, EventKind::cell_ranked);
      EXPECT_EQ(event.measured, is.density);
      EXPECT_EQ(event.limit, was.density);
      EXPECT_EQ(now.tree.cells.size(), before.tree.cells.size());
    }
    if (event.rule == Rule::advancing_front || event.rule == Rule::balance) {
      std::vector<std::int32_t> around;
      neighboursOf(before.tree, static_cast<std::int32_t>(event.other), around);
      EXPECT_EQ(std::ranges::count(around, subject), 1) << "the cell it came from is no neighbour";
    }
  });
}

// A single fine point in a large square: ranks grow by one from cell to cell, until they reach the limit given.
TEST(DensityLimits, MaxRankIsTheCoarsest) {
  const support::DomainPtr domain = support::domainFrom(R"({"min_edge_length": 1,
    "outer": [[-256, -256], [256, -256], [256, 256], [-256, 256]], "density": [{"at": [0, 0], "length": 1}]})");
  Settings settings;
  settings.maxRank = 6;
  const MeshState state = support::after(domain, Stage::density, settings);
  int coarsest = 0;
  eachLeaf(state.tree, [&](std::int32_t, const Cell& cell) { coarsest = std::max<int>(coarsest, cell.density); });
  EXPECT_EQ(coarsest, 6);
  EXPECT_EQ(densityRankAt(state.tree, {0, 0}), 1);
}

TEST(BoundaryTree, KnowsInsideFromOutside) {
  const support::DomainPtr domain = support::domainFrom(support::kNotched);
  const BoundaryTree tree = boundaryTreeOf(*domain, 0.2);
  for (const Point p : {Point{0.5, 0.5}, Point{9.9, 5.9}, Point{5.5, 1.1}, Point{3.6, 4.0}}) {
    EXPECT_TRUE(insideDomain(tree, p)) << p.x << ", " << p.y;
  }
  for (const Point p : {Point{-0.5, 0.5}, Point{5.5, 5.0}, Point{2, 1.5}, Point{7.5, 2.5}, Point{11, 3}}) {
    EXPECT_FALSE(insideDomain(tree, p)) << p.x << ", " << p.y;
  }
}

TEST(BoundaryTree, RaysHitTheFirstPieceOnTheWay) {
  const support::DomainPtr domain = support::domainFrom(support::kNotched);
  const BoundaryTree tree = boundaryTreeOf(*domain, 0.2);
  support::Random random{51};
  for (int k = 0; k < 500; ++k) {
    const auto own = static_cast<std::uint32_t>(random.below(domain->curves.size()));
    const Curve& curve = domain->curves[own];
    const Point origin = curve.a + random.unit() * (curve.b - curve.a);
    const Point direction{random.between(-1, 1), random.between(-1, 1)};
    double nearest = 1e300;
    for (const BoundaryPiece& piece : tree.pieces) {
      const Curve& other = domain->curves[piece.curve];
      if (piece.curve == own || other.a == curve.a || other.a == curve.b || other.b == curve.a || other.b == curve.b)
        continue;
      const Point edge = piece.b - piece.a;
      const double across = cross(direction, edge);
      const double s = cross(piece.a - origin, edge) / across;
      const double u = cross(piece.a - origin, direction) / across;
      if (s > 0.0 && u >= 0.0 && u <= 1.0) nearest = std::min(nearest, s);
    }
    EXPECT_EQ(castRay(tree, *domain, origin, direction, own).distance, nearest);
  }
}

}  // namespace
}  // namespace triscope::density_test
