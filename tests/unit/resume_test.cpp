// The kernel is a value: however a run is cut up, copied or listened to, it ends in the same bytes.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/mesh/edit.h"
#include "support/ids.h"
#include "support/random.h"
#include "support/runs.h"

namespace triscope::resume_test {
namespace {

using support::DomainPtr;
using support::Random;

struct NamedDomain {
  const char* name;
  const char* json;
};

void PrintTo(const NamedDomain& domain, std::ostream* out) { *out << domain.name; }

class Resume : public testing::TestWithParam<NamedDomain> {
 protected:
  DomainPtr domain = support::domainFrom(GetParam().json);
};

INSTANTIATE_TEST_SUITE_P(Domains, Resume,
                         testing::Values(NamedDomain{"frame", support::kFrame},
                                         NamedDomain{"cracked_frame", support::kCrackedFrame},
                                         NamedDomain{"round", support::kRound}),
                         [](const auto& named) { return named.param.name; });

MeshState carriedOn(MeshState state, Grain grain, Journal journal = {}) {
  while (advance(state, grain, journal)) {
  }
  return state;
}

TEST_P(Resume, EveryGrainEndsInTheSameBytes) {
  const std::uint64_t whole = hashOf(support::finished(domain));
  for (const Grain grain : {Grain::decision, Grain::insertion, Grain::stage, Grain::round}) {
    const MeshState state = carriedOn(support::start(domain), grain);
    EXPECT_EQ(state.stage, Stage::finished);
    EXPECT_EQ(hashOf(state), whole) << "grain " << static_cast<int>(grain);
  }
  MeshState state = support::start(domain);
  Journal nobody;
  for (std::uint64_t limit = 1; advanceUntil(state, Stage::optimise, limit, nobody); limit = limit % 7 + 1) {
  }
  EXPECT_EQ(hashOf(state), whole) << "by beats";
}

TEST_P(Resume, CopiesTakenAtRandomDecisionsEndInTheSameBytes) {
  const Settings settings = support::withoutOptimiser();  // optimise_test.cpp does the same with it
  const MeshState whole = support::finished(domain, settings);
  Random random{2024};
  std::set<std::uint64_t> ticks;
  while (ticks.size() < 100) ticks.insert(random.below(whole.tick));
  MeshState state = support::start(domain, settings);
  Journal nobody;
  for (const std::uint64_t tick : ticks) {
    while (state.tick < tick) ASSERT_TRUE(advance(state, Grain::decision, nobody));
    const std::uint64_t here = hashOf(state);
    MeshState copy = state;
    ASSERT_EQ(hashOf(copy), here);
    copy = carriedOn(std::move(copy), static_cast<Grain>(random.below(5)));
    EXPECT_EQ(hashOf(copy), hashOf(whole)) << "copied after " << tick << " decisions";
    ASSERT_EQ(hashOf(state), here) << "carrying on the copy changed the original after " << tick << " decisions";
  }
}

// Two runs that take turns share whatever scratch memory the stages keep.
TEST_P(Resume, RunsThatTakeTurnsDoNotDisturbEachOther) {
  const DomainPtr otherDomain = support::domainFrom(support::kFrame);
  const std::uint64_t whole = hashOf(support::finished(domain));
  const std::uint64_t otherWhole = hashOf(support::finished(otherDomain, support::withoutStep6()));
  MeshState state = support::start(domain);
  MeshState other = support::start(otherDomain, support::withoutStep6());
  Journal nobody;
  bool more = true;
  bool otherMore = true;
  while (more || otherMore) {
    more = advance(state, Grain::decision, nobody);
    otherMore = advance(other, Grain::decision, nobody);
  }
  EXPECT_EQ(hashOf(state), whole);
  EXPECT_EQ(hashOf(other), otherWhole);
}

TEST_P(Resume, ListeningChangesNothing) {
  const MeshState silent = support::finished(domain);
  std::vector<Event> events;
  const MeshState heard = carriedOn(support::start(domain), Grain::all, Journal{&events});
  EXPECT_EQ(hashOf(heard), hashOf(silent));
  EXPECT_GE(events.size(), heard.tick);
  for (std::size_t s = 0; s < heard.counts.size(); ++s) {
    EXPECT_EQ(heard.counts[s].decisions, silent.counts[s].decisions);
    EXPECT_EQ(heard.counts[s].inserted, silent.counts[s].inserted);
    EXPECT_EQ(heard.counts[s].refused, silent.counts[s].refused);
    EXPECT_EQ(heard.counts[s].moved, silent.counts[s].moved);
    EXPECT_EQ(heard.counts[s].removed, silent.counts[s].removed);
  }
}

TEST_P(Resume, TheSameDomainReadAgainGivesTheSameBytes) {
  EXPECT_EQ(hashOf(support::finished(support::domainFrom(GetParam().json))), hashOf(support::finished(domain)));
}

// A vertex number and a triangle id name one thing for good; a vertex that is gone does not come back.
TEST_P(Resume, NumbersAndIdsAreNeverReused) {
  MeshState state = support::start(domain);
  Journal nobody;
  std::size_t vertices = 0;
  TriangleId nextId{0};
  Per<Vertex, std::uint8_t> removed;
  Per<TriangleId, Corners<Vertex>> cornersOf;  // of each id ever seen
  Per<TriangleId, std::uint8_t> ended;         // ids that were seen and are gone
  while (advance(state, Grain::decision, nobody)) {
    const Mesh& mesh = state.mesh;
    ASSERT_GE(mesh.points.size(), vertices);
    ASSERT_GE(mesh.nextId, nextId);
    vertices = mesh.points.size();
    nextId = mesh.nextId;
    removed.resize(vertices, 0);
    for (const Vertex v : removed.keys()) {
      if (removed[v] != 0) {
        ASSERT_EQ(mesh.kinds[v], VertexKind::removed) << "vertex " << v << " came back";
      }
      removed[v] = mesh.kinds[v] == VertexKind::removed ? 1 : 0;
    }
    cornersOf.resize(nextId.n);
    ended.resize(nextId.n, 0);
    Per<TriangleId, std::uint8_t> live(nextId.n, 0);
    for (const Slot slot : mesh.triangles.keys()) {
      if ((mesh.flags[slot] & kDead) != 0) continue;
      const TriangleId id = mesh.ids[slot];
      ASSERT_LT(id, nextId);
      ASSERT_EQ(live[id], 0) << "two triangles have the id " << id;
      ASSERT_EQ(ended[id], 0) << "triangle " << id << " came back";
      live[id] = 1;
      auto corners = mesh.triangles[slot].v;
      std::ranges::sort(corners.at);
      if (!cornersOf[id][0].exists()) cornersOf[id] = corners;
      ASSERT_EQ(corners, cornersOf[id]) << "triangle " << id << " became another";
    }
    for (const TriangleId id : ended.keys()) {
      if (cornersOf[id][0].exists() && live[id] == 0) ended[id] = 1;
    }
  }
  EXPECT_GT(vertices, 50u);
}

}  // namespace
}  // namespace triscope::resume_test
