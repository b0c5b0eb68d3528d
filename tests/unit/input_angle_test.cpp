// The input angles that excuse a triangle from the bounds.
#include "core/quality/input_angle.h"

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace triscope::input_angle_test {
namespace {

using support::meshOf;
using support::operator""_slot;

TEST(SmallInputAngle, IsTheWholeAngleBetweenBoundaryEdges) {
  // An angle of 45 degrees at the origin, shared by two triangles of about half of it.
  const Mesh mesh = meshOf({{0, 0}, {4, 0}, {4, 2}, {3, 3}}, {{0, 1, 2}, {0, 2, 3}});
  for (const Slot slot : {0_slot, 1_slot}) {
    const auto angle = smallInputAngle(mesh, slot);
    ASSERT_TRUE(angle.has_value());
    EXPECT_EQ(angle->at, (Point{0, 0}));
    EXPECT_NEAR(angle->degrees, 45.0, 1e-9);
  }
}

TEST(SmallInputAngle, IsNoneInTheInteriorAndAtSixtyDegrees) {
  // A hexagon about the origin: triangles of 60 degrees, and no boundary at the middle.
  const double h = 0.8660254037844386;
  std::vector<std::array<int, 3>> triangles;
  for (int k = 0; k < 6; ++k) triangles.push_back({0, 1 + k, 1 + (k + 1) % 6});
  const Mesh hexagon = meshOf({{0, 0}, {1, 0}, {0.5, h}, {-0.5, h}, {-1, 0}, {-0.5, -h}, {0.5, -h}}, triangles);
  for (Slot slot(0); slot < 6_slot; ++slot) EXPECT_FALSE(smallInputAngle(hexagon, slot).has_value());
  EXPECT_FALSE(smallInputAngle(meshOf({{0, 0}, {1, 0}, {0.5, h}}, {{0, 1, 2}}), 0_slot).has_value());
}

}  // namespace
}  // namespace triscope::input_angle_test
