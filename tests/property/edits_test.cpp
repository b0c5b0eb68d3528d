// Long random sequences of edits, on random domains and on lattices full of ties.
#include <gtest/gtest.h>

#include <array>

#include "core/mesh/move.h"
#include "core/mesh/remove.h"
#include "support/edits.h"
#include "support/judge.h"
#include "support/meshes.h"
#include "support/random_domains.h"
#include "support/runs.h"

namespace triscope::edits_test {
namespace {

using support::Random;
using support::operator""_v;

TEST(RandomEdits, LeaveAValidMeshOfTheDomain) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random{seed};
    const auto shape = static_cast<support::Shape>(random.below(support::kShapes));
    const std::string text = support::randomDomain(random, shape, {});
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + text);
    MeshState state = support::after(support::domainFrom(text), Stage::front1);
    support::EditCounts counts;
    for (int k = 0; k < 300; ++k) {
      const std::string edit = support::editAtRandom(state, random, counts);
      if (k % 50 != 49) continue;
      support::expectValid(state.mesh);
      ASSERT_FALSE(HasFailure()) << "at the latest after edit " << k << ", " << edit;
    }
    support::expectFollowsDomain(state);
  }
}

// Every position is one of few: most points lie on lines and circles through others.
TEST(RandomEdits, StayDelaunayOnALattice) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random{seed};
    const double unit = std::array{1.0, 0.1, 1e-9, 1e7}[random.below(4)];
    const Point origin = unit < 0.1 || random.below(2) == 0 ? Point{} : Point{3e7, -2e7};
    const std::size_t size = 3 + random.below(6);
    const auto somewhere = [&] {
      return origin + unit * Point{static_cast<double>(random.below(size)), static_cast<double>(random.below(size))};
    };
    Mesh mesh = support::boxMesh(origin - Point{2 * unit, 3 * unit},
                                 origin + unit * Point{static_cast<double>(size) + 2, static_cast<double>(size) + 1});
    MoveLog log;
    for (int k = 0; k < 300; ++k) {
      const Vertex vertex(3 + random.below(mesh.points.size() - 3));
      const bool inner = vertex >= 4_v && mesh.vertexTriangle[vertex].exists();
      const std::size_t which = random.below(4);
      if (which < 2) {
        support::insert(mesh, somewhere());
      } else if (which == 2 && inner) {
        ASSERT_TRUE(removeVertex(mesh, vertex));
      } else if (inner) {
        const Mesh before = mesh;
        if (moveVertex(mesh, vertex, somewhere(), log) && random.below(2) == 0) {
          undoMove(mesh, log);
          ASSERT_EQ(support::difference(mesh, before), "");
        }
      }
      if (k % 30 != 29) continue;
      support::expectValid(mesh);
      support::expectDelaunayByBruteForce(mesh);
      ASSERT_FALSE(HasFailure()) << "at the latest after edit " << k;
    }
  }
}

}  // namespace
}  // namespace triscope::edits_test
