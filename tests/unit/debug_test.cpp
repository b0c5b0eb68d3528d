// Conditions and breakpoints against brute force over the recorded run.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <memory>
#include <string>

#include "core/domain/read.h"
#include "core/quality/quality.h"
#include "core/run/breakpoint.h"
#include "support/optimised.h"
#include "support/runs.h"

namespace triscope::debug_test {
namespace {

MeshState start(const std::string& sample) {
  Result<Domain> domain = readDomain(std::string(TRISCOPE_SOURCE_DIR) + "/assets/domains/" + sample + ".json");
  EXPECT_TRUE(domain.ok());
  Result<MeshState> state = begin(std::make_shared<const Domain>(std::move(*domain)), {});
  return std::move(*state);
}

std::vector<Breakpoint> stopAt(const std::string& text) {
  Result<Condition> condition = Condition::compile(text);
  EXPECT_TRUE(condition.ok()) << condition.error().message;
  return {{std::move(*condition)}};
}

std::string complaint(const std::string& text) {
  const Result<Condition> condition = Condition::compile(text);
  return condition ? "" : condition.error().message;
}

TEST(Condition, ErrorsPointAtTheCharacter) {
  EXPECT_NE(complaint("aspect >> 4").find("\n  aspect >> 4\n          ^\nexpected a number"), std::string::npos)
      << complaint("aspect >> 4");
  EXPECT_NE(complaint("aspct > 4").find("\n  ^\nexpected one of: aspect"), std::string::npos);
  EXPECT_NE(complaint("stage == step9").find("expected one of: constraints"), std::string::npos);
  EXPECT_NE(complaint("stage > step3").find("expected == or != after stage"), std::string::npos);
  EXPECT_NE(complaint("(aspect > 4").find("expected \")\""), std::string::npos);
  EXPECT_NE(complaint("aspect > 4 aspect").find("expected \"and\""), std::string::npos);
  EXPECT_NE(complaint("triangle == 1.5").find("a whole number"), std::string::npos);
  EXPECT_NE(complaint("").find("expected one of"), std::string::npos);
  EXPECT_NE(complaint(std::string(5000, '(')).find("less nesting"), std::string::npos);
  EXPECT_NE(complaint(std::string(5000, '!')).find("less nesting"), std::string::npos);
}

TEST(Condition, EveryWordCompiles) {
  for (const Word& word : conditionWords()) {
    std::string text(word.name);
    if (word.kind == Word::Kind::number || word.kind == Word::Kind::id) text += " == 1";
    if (word.name == "stage") text += " == refine";
    if (word.name == "event") text += " == vertex_inserted";
    if (word.name == "rule") text += " == step_3";
    if (word.name == "refusal") text += " != too_close";
    EXPECT_EQ(complaint(text), "");
  }
}

TEST(Condition, EveryWordIsDocumented) {
  std::ifstream file(std::string(TRISCOPE_SOURCE_DIR) + "/docs/conditions.md");
  const std::string docs((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  for (const Word& word : conditionWords()) {
    EXPECT_NE(docs.find("`" + std::string(word.name) + "`"), std::string::npos) << word.name;
  }
}

TEST(Breakpoint, StopsWhereTheAspectRatioFirstFallsBelowALimit) {
  const auto breakpoints = stopAt("aspect < 5 and triangles > 100");
  MeshState state = start("blunt_body");
  std::vector<Hit> passed;
  const auto hit = continueForward(state, breakpoints, passed);
  ASSERT_TRUE(hit.has_value());
  EXPECT_EQ(hit->tick, state.tick);

  // Brute force: measure everything after every decision.
  MeshState again = start("blunt_body");
  Journal journal;
  while (advance(again, Grain::decision, journal)) {
    const Quality q = measure(again.mesh);
    if (q.aspectMax < 5 && again.mesh.liveCount() > 100) break;
  }
  EXPECT_EQ(again.tick, hit->tick);
}

TEST(Breakpoint, BackwardsFindsTheLastRefusalBeforeHere) {
  const auto breakpoints = stopAt("refused");
  MeshState state = start("l_shape");
  History history(std::size_t{256} << 10);
  history.restart(state);
  std::vector<Event> events;
  Journal journal{&events};
  std::vector<std::uint64_t> refusedAt;
  for (std::uint64_t tick = 0; advance(state, Grain::decision, journal) && state.tick > tick; tick = state.tick) {
    history.offer(state, events.size());
    if (events.back().refusal != Refusal::none) refusedAt.push_back(state.tick);
  }
  ASSERT_GT(refusedAt.size(), 20u);
  std::uint64_t here = state.tick + 1;
  for (std::size_t k = refusedAt.size(); k-- > refusedAt.size() - 20;) {
    const auto hit = continueBackward(history, here, breakpoints);
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->tick, refusedAt[k]);
    here = hit->tick;
  }
  const auto none = continueBackward(history, refusedAt.front(), breakpoints);
  EXPECT_FALSE(none.has_value());
  // From the end all the way back over every keyframe.
  EXPECT_GT(history.count(), 2u);
  EXPECT_FALSE(continueBackward(history, state.tick + 1, stopAt("tick == 0 and refused")).has_value());
}

TEST(Breakpoint, NoRuleIsBrokenInTheRunsOfTheSamples) {
  for (const std::string sample : {"annulus", "l_shape", "blunt_body", "cracked_plate"}) {
    for (const Settings& settings : {Settings(), support::best(), support::optimised()}) {
      MeshState state = support::start(start(sample).domain, settings);
      std::vector<Hit> passed;
      const auto breakpoints = violationBreakpoints();
      const auto hit = continueForward(state, breakpoints, passed);
      EXPECT_FALSE(hit.has_value()) << sample << " at " << hit->tick << ": "
                                    << breakpoints[hit->breakpoint].condition.text();
    }
  }
}

TEST(Breakpoint, ABrokenRuleIsFound) {
  // The mesh is spoilt by hand in the middle of step 6: the next decision nearby shows it.
  MeshState state = start("l_shape");
  Journal journal;
  advanceUntil(state, Stage::step5, ~std::uint64_t{0}, journal);
  const Vertex spoilt = state.front1.at(3);
  state.mesh.points[spoilt] = state.mesh.points[spoilt] + Point{0.5, 0.5};
  std::vector<Hit> passed;
  EXPECT_TRUE(continueForward(state, violationBreakpoints(), passed).has_value());
}

}  // namespace
}  // namespace triscope::debug_test
