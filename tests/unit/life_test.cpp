// When triangles ended, held against a look at every decision.
#include "core/explain/life.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "core/explain/why.h"
#include "support/domains.h"
#include "support/ids.h"
#include "support/recorded.h"
#include "support/runs.h"

namespace triscope::life_test {
namespace {

TEST(Life, DeathIsFoundWhereTheTriangleLastWas) {
  // Brute force: after every decision, which triangles are gone.
  const auto domain = support::domainAt(support::samples() / "l_shape.json");
  const support::Recorded tiny = support::record(domain, std::size_t{64} << 10);
  MeshState state = support::start(domain);
  std::vector<Event> events;
  Journal journal{&events};
  std::map<TriangleId, std::size_t> death;
  std::set<TriangleId> alive;
  while (advance(state, Grain::decision, journal)) {
    std::set<TriangleId> now;
    for (const Slot s : state.mesh.ids.keys())
      if (state.mesh.alive(s)) now.insert(state.mesh.ids[s]);
    for (const TriangleId id : alive)
      if (now.count(id) == 0) death[id] = events.size() - 1;
    alive = std::move(now);
  }
  ASSERT_GT(death.size(), 100u);
  std::uint32_t checked = 0;
  for (TriangleId id(0); id < state.mesh.nextId; id.n += 13, ++checked) {
    const TriangleFacts facts = factsOf(tiny.history, tiny.end.tick, tiny.events, id);
    const auto found = death.find(id);
    if (found == death.end() && alive.count(id) == 0) continue;  // made and ended by one decision
    EXPECT_EQ(facts.death, found == death.end() ? std::nullopt : std::optional<std::size_t>(found->second)) << id;
    EXPECT_NE(facts.corners[0], kNoId) << id;
  }
  EXPECT_GT(checked, 50u);
}

}  // namespace
}  // namespace triscope::life_test
