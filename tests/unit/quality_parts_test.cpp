// A mesh that is measured where it has changed has the figures of one measured from scratch, to the last bit.
#include "core/quality/quality_parts.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "core/domain/read.h"
#include "core/mesh/mesh_changes.h"
#include "core/run/history.h"

namespace triscope::quality_parts_test {
namespace {

void expectSame(const Quality& a, const Quality& b) {
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.boundaryVertices, b.boundaryVertices);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.obtuse, b.obtuse);
  EXPECT_EQ(a.aspectMax, b.aspectMax);
  EXPECT_EQ(a.aspectAt, b.aspectAt);
  EXPECT_EQ(a.areaRatioMax, b.areaRatioMax);
  EXPECT_EQ(a.areaRatioAt, b.areaRatioAt);
  EXPECT_EQ(a.areaRatioOther, b.areaRatioOther);
  EXPECT_EQ(a.edgeRatioMax, b.edgeRatioMax);
  EXPECT_EQ(a.edgeRatioAt, b.edgeRatioAt);
  EXPECT_EQ(a.minAngle, b.minAngle);
  EXPECT_EQ(a.minAngleAt, b.minAngleAt);
  EXPECT_EQ(a.maxAngle, b.maxAngle);
  EXPECT_EQ(a.maxAngleAt, b.maxAngleAt);
  EXPECT_EQ(a.minEdge, b.minEdge);
  EXPECT_EQ(a.minEdgeAt, b.minEdgeAt);
  EXPECT_EQ(a.area, b.area);
  EXPECT_EQ(a.aspectMean, b.aspectMean);
}

TEST(QualityParts, FollowARunForwardsAndBackwards) {
  Result<Domain> domain = readDomain(std::string(TRISCOPE_SOURCE_DIR) + "/assets/domains/naca0012.json");
  ASSERT_TRUE(domain.ok());
  Result<MeshState> start = begin(std::make_shared<const Domain>(std::move(*domain)), {});
  ASSERT_TRUE(start.ok());
  Journal deaf;
  History history;
  history.restart(*start);
  MeshState end = *start;
  while (advance(end, Grain::decision, deaf)) history.offer(end, 0);

  MeshState before = *start;
  QualityInParts measured = measureInParts(before.mesh);
  std::uint64_t tick = 0;
  std::size_t few = 0;  // times that only some of the mesh was measured
  for (std::uint64_t k = 0; k < 120; ++k) {
    // Far for the most part in even rounds, and to and fro nearby in the others.
    tick = k % 8 == 0 ? end.tick * (k * 37 % 120) / 120 : k % 3 == 0 ? tick + 5 * k : tick > k ? tick - k : tick + 1;
    MeshState now = history.seek(tick, deaf);
    measured = measureInParts(now.mesh, before.mesh, std::move(measured));
    if (measured.parts.size() > 2 && changedSlots(before.mesh, now.mesh, 1000)) ++few;
    expectSame(measured.quality, measure(now.mesh));
    ASSERT_FALSE(HasFailure()) << "from decision " << before.tick << " to " << now.tick;
    before = std::move(now);
  }
  EXPECT_GT(few, 20u);
}

}  // namespace
}  // namespace triscope::quality_parts_test
