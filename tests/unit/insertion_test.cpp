// An insertion taken apart: the walk and the cavity are those of the run itself.
#include "core/explain/insertion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <vector>

#include "core/geometry/predicates.h"
#include "core/method/pipeline.h"
#include "core/words/vocabulary.h"
#include "support/domains.h"
#include "support/ids.h"
#include "support/runs.h"

namespace triscope::insertion_test {
namespace {

using Ids = std::vector<TriangleId>;  // ascending

Ids liveIds(const Mesh& mesh) {
  Ids ids;
  for (const Slot slot : mesh.ids.keys())
    if (mesh.alive(slot)) ids.push_back(mesh.ids[slot]);
  std::sort(ids.begin(), ids.end());
  return ids;
}

bool holds(const Mesh& mesh, Slot slot, Point p) {
  const Triangle& t = triangleAt(mesh, slot);
  for (std::size_t i = 0; i < 3; ++i)
    if (orient2d(pointOf(mesh, t.v[i]), pointOf(mesh, t.v[(i + 1) % 3]), p) < 0) return false;
  return true;
}

bool areNeighbours(const Mesh& mesh, Slot a, Slot b) {
  const auto& adj = triangleAt(mesh, a).adj;
  return std::any_of(adj.begin(), adj.end(), [b](Half half) { return half.exists() && triangleOf(half) == b; });
}

/// Ids of the triangles that the decision between two states took away.
Ids goneBetween(const MeshState& before, const MeshState& after) {
  const Ids was = liveIds(before.mesh);
  const Ids is = liveIds(after.mesh);
  Ids gone;
  std::set_difference(was.begin(), was.end(), is.begin(), is.end(), std::back_inserter(gone));
  return gone;
}

void expectAgreement(const MeshState& before, const MeshState& after, const Event& event) {
  const std::optional<Insertion> found = takeApart(before, event);
  ASSERT_TRUE(found);
  const Mesh& mesh = before.mesh;
  EXPECT_EQ(found->at, pointOf(after.mesh, Vertex(event.vertex)));
  // The cavity is what the insertion took away; a split may have flipped more.
  Ids cavity;
  for (const Slot slot : found->cavity.triangles()) cavity.push_back(idOf(mesh, slot));
  std::sort(cavity.begin(), cavity.end());
  const Ids gone = goneBetween(before, after);
  EXPECT_EQ(cavity.size(), event.removedCount);
  EXPECT_TRUE(std::includes(gone.begin(), gone.end(), cavity.begin(), cavity.end()));
  if (event.createdCount == found->cavity.rimCount) {
    EXPECT_EQ(cavity, gone);
  }
  // The walk goes from triangle to neighbour and ends in the cavity, where the point is.
  if (!found->splits.exists()) {
    ASSERT_FALSE(found->walk.empty());
    for (std::size_t k = 1; k < found->walk.size(); ++k)
      EXPECT_TRUE(areNeighbours(mesh, found->walk[k - 1], found->walk[k]));
    EXPECT_TRUE(holds(mesh, found->walk.back(), found->at));
    EXPECT_TRUE(std::binary_search(cavity.begin(), cavity.end(), idOf(mesh, found->walk.back())));
  }
  if (event.rule >= Rule::step1 && event.rule <= Rule::step5) {
    ASSERT_TRUE(found->measured);
    EXPECT_EQ(idOf(mesh, found->candidate), TriangleId(event.subject));
    EXPECT_NEAR(distance(found->measured->from, found->measured->to), event.measured, 1e-9 * event.measured);
    EXPECT_GE(found->measured->length, found->measured->limit * (1.0 - 1e-9));
  }
  // Each phase says something with figures.
  for (int k = 1; k <= kInsertionPhases; ++k) {
    const std::string text = captionOf(*found, mesh, static_cast<InsertionPhase>(k));
    EXPECT_NE(text.find_first_of("0123456789"), std::string::npos) << text;
  }
}

TEST(Insertion, AgreesWithTheRun) {
  std::array<int, static_cast<std::size_t>(kRuleCount)> seen{};
  for (const char* const text : {support::kFrame, support::kCrackedFrame, support::kNotched}) {
    MeshState state = support::start(support::domainFrom(text), support::withoutStep6());
    for (;;) {
      MeshState before = state;
      std::vector<Event> events;
      Journal journal{&events};
      if (!advance(state, Grain::decision, journal)) break;
      // A decision of the repair may consist of two edits: only the first starts from the state before.
      const auto changes = [](const Event& e) { return e.kind > EventKind::boundary_point && e.createdCount > 0; };
      const auto first = std::find_if(events.begin(), events.end(), changes);
      if (before.mesh.triangles.empty() || first == events.end() || !inserts(*first)) continue;
      if (std::count_if(events.begin(), events.end(), changes) != 1) continue;
      ++seen[static_cast<std::size_t>(first->rule)];
      expectAgreement(before, state, *first);
      if (testing::Test::HasFailure()) FAIL() << "decision " << state.tick << " of " << text;
    }
  }
  for (const Rule rule : {Rule::initial, Rule::first_front, Rule::second_front, Rule::step1, Rule::step2})
    EXPECT_GT(seen[static_cast<std::size_t>(rule)], 0) << name(rule);
}

TEST(Insertion, NothingBeforeThereIsATriangulation) {
  const MeshState start = support::start(support::domainFrom(support::kFrame));
  Event event;
  event.kind = EventKind::vertex_inserted;
  event.vertex = 0;
  EXPECT_FALSE(takeApart(start, event));
}

}  // namespace
}  // namespace triscope::insertion_test
