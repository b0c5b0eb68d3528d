// How triangles came by their shapes, held against the meshes that the same runs went through.
#include "core/explain/shape_story.h"

#include <gtest/gtest.h>

#include "core/explain/life.h"
#include "core/quality/quality.h"
#include "core/words/vocabulary.h"
#include "support/ids.h"
#include "support/recorded.h"

namespace triscope::shape_story_test {
namespace {

TEST(ShapeStory, EndsWithTheShapeThatTheTriangleHas) {
  for (const char* sample : {"l_shape", "blunt_body", "cracked_plate"}) {
    const support::Recorded& run = support::runOf(sample);
    const Mesh& mesh = run.end.mesh;
    std::size_t moved = 0;
    for (const Slot slot : mesh.triangles.keys()) {
      if (!mesh.alive(slot)) continue;
      const TriangleId id = idOf(mesh, slot);
      const auto birth = birthOf(run.events, {Ref::Kind::triangle, id.word()});
      ASSERT_TRUE(birth);
      const auto story = shapeStoryOf(run.events, *birth, *factsOf(mesh, id));
      ASSERT_TRUE(story) << id;
      const Triangle& t = mesh.triangles[slot];
      const double aspect = qualityOf(pointOf(mesh, t.v[0]), pointOf(mesh, t.v[1]), pointOf(mesh, t.v[2])).aspect;
      EXPECT_NEAR(story->moves.empty() ? story->atBirth : story->moves.back().after, aspect, 1e-9) << id;
      double is = story->atBirth;
      for (const ShapeChange& move : story->moves) {
        EXPECT_EQ(move.before, is);
        is = move.after;
        EXPECT_TRUE(placesVertex(run.events[move.event]));
      }
      moved += story->moves.size();
    }
    EXPECT_GT(moved, 1000u) << sample;
  }
}

TEST(ShapeStory, IsWhatTheMeshWasBeforeAndAfterEachMove) {
  const support::Recorded& run = support::runOf("l_shape");
  const Mesh& end = run.end.mesh;
  std::size_t looked = 0;
  for (std::size_t n = 0; n < end.triangles.size(); n += 97) {
    const Slot slot(n);
    if (!end.alive(slot)) continue;
    const TriangleId id = idOf(end, slot);
    const auto birth = birthOf(run.events, {Ref::Kind::triangle, id.word()});
    const auto story = shapeStoryOf(run.events, *birth, *factsOf(end, id));
    ASSERT_TRUE(story);
    Journal nobody;
    const auto aspectAt = [&](std::uint64_t tick) {
      const MeshState then = run.history.seek(tick, nobody);
      const Slot there = slotOf(then.mesh, id);
      EXPECT_TRUE(there.exists());
      const Triangle& t = then.mesh.triangles[there];
      return qualityOf(pointOf(then.mesh, t.v[0]), pointOf(then.mesh, t.v[1]), pointOf(then.mesh, t.v[2])).aspect;
    };
    if (story->moves.empty() || run.tickAt[story->moves.front().event] != run.tickAt[*birth]) {
      EXPECT_NEAR(aspectAt(run.tickAt[*birth]), story->atBirth, 1e-9);
    }
    // An edit moves a corner again where it smoothes what it has made: the mesh is known before and after it as a
    // whole.
    const std::vector<ShapeChange>& moves = story->moves;
    const auto tickOf = [&](std::size_t k) { return run.tickAt[moves[k].event]; };
    for (std::size_t k = 0; k < moves.size(); ++k, ++looked) {
      const bool first = k == 0 ? tickOf(k) != run.tickAt[*birth] : tickOf(k) != tickOf(k - 1);
      const bool last = k + 1 == moves.size() || tickOf(k) != tickOf(k + 1);
      if (first) {
        EXPECT_NEAR(aspectAt(tickOf(k) - 1), moves[k].before, 1e-9);
      }
      if (last) {
        EXPECT_NEAR(aspectAt(tickOf(k)), moves[k].after, 1e-9);
      }
    }
  }
  EXPECT_GT(looked, 30u);
}

}  // namespace
}  // namespace triscope::shape_story_test
