// The rows of vocabulary.h: complete, distinct, true of the events that runs make, and each of them made by some run.
#include "core/words/vocabulary.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <set>
#include <string>

#include "core/explain/fields.h"
#include "core/mesh/mesh.h"
#include "core/run/condition.h"
#include "core/run/element_events.h"
#include "support/optimised.h"
#include "support/runs.h"

namespace triscope::vocabulary_test {
namespace {

EventKind kindAt(int k) { return static_cast<EventKind>(k); }
Rule ruleAt(int k) { return static_cast<Rule>(k); }
Refusal refusalAt(int k) { return static_cast<Refusal>(k); }

TEST(Vocabulary, EveryKindRuleAndRefusalHasItsOwnName) {
  std::set<std::string_view> kinds, rules, refusals;
  for (int k = 0; k < kEventKindCount; ++k) kinds.insert(name(kindAt(k)));
  for (int k = 0; k < kRuleCount; ++k) rules.insert(name(ruleAt(k)));
  for (int k = 0; k < kRefusalCount; ++k) refusals.insert(name(refusalAt(k)));
  EXPECT_EQ(kinds.size(), static_cast<std::size_t>(kEventKindCount));
  EXPECT_EQ(rules.size(), static_cast<std::size_t>(kRuleCount));
  EXPECT_EQ(refusals.size(), static_cast<std::size_t>(kRefusalCount));
  EXPECT_FALSE(kinds.contains("") || rules.contains("") || refusals.contains(""));
}

TEST(Vocabulary, RowsStandBesideTheirEnumerators) {
  EXPECT_EQ(name(EventKind::cell_ranked), "cell ranked");
  EXPECT_EQ(name(EventKind::failure), "failure");
  EXPECT_EQ(name(Rule::user_request), "user request");
  EXPECT_EQ(name(Rule::second_front), "second front");
  EXPECT_EQ(name(Rule::step3), "step 3");
  EXPECT_EQ(name(Rule::polish), "polish");
  EXPECT_EQ(name(Refusal::too_close), "too close");
  EXPECT_EQ(name(Refusal::budget_spent), "budget spent");
  EXPECT_EQ(name(Refusal::too_many_triangles), "too many triangles");
}

TEST(Vocabulary, OnlyNoneNeedsNoWords) {
  for (int k = 0; k < kEventKindCount; ++k) EXPECT_FALSE(wordsOf(kindAt(k)).caption.empty()) << name(kindAt(k));
  for (int k = 1; k < kRuleCount; ++k) EXPECT_FALSE(describe(ruleAt(k)).empty()) << name(ruleAt(k));
  for (int k = 1; k < kRefusalCount; ++k) EXPECT_FALSE(describe(refusalAt(k)).empty()) << name(refusalAt(k));
  for (int k = 1; k < kRuleCount; ++k) {
    const RuleWords& words = wordsOf(ruleAt(k));
    EXPECT_NE(words.family, Family::none) << words.name;
    const bool tries = words.family == Family::step || words.family == Family::repair || words.family == Family::move;
    EXPECT_EQ(!words.silent.empty(), tries) << words.name;
    EXPECT_EQ(!words.limit.empty(), words.family == Family::step) << words.name;
  }
}

TEST(Vocabulary, UnknownNumbersHaveNoWords) {
  EXPECT_EQ(name(ruleAt(200)), "");
  EXPECT_EQ(name(refusalAt(200)), "");
  EXPECT_EQ(name(kindAt(200)), "");
}

void expectFields(std::string_view text) {
  for (std::size_t open = text.find('{'); open != std::string_view::npos; open = text.find('{', open + 1)) {
    const std::size_t close = text.find('}', open);
    ASSERT_NE(close, std::string_view::npos) << text;
    EXPECT_TRUE(isField(text.substr(open + 1, close - open - 1))) << text;
  }
}

TEST(Vocabulary, TemplatesNameFieldsThatThereAre) {
  for (int k = 0; k < kEventKindCount; ++k) expectFields(wordsOf(kindAt(k)).caption);
  for (int k = 0; k < kRefusalCount; ++k) expectFields(wordsOf(refusalAt(k)).figures);
  for (int k = 0; k < kRuleCount; ++k) {
    const RuleWords& words = wordsOf(ruleAt(k));
    for (const std::string_view text : {words.reason, words.inserted, words.refused}) expectFields(text);
  }
  EXPECT_EQ(filled("{no_such_field} {", {}), "{no_such_field} {") << "shown, so that it is seen";
}

support::DomainPtr domainOf(const std::string& text) {
  Result<Domain> domain = parseDomain(text, "vocabulary_test");
  if (!domain) ADD_FAILURE() << describe(domain.error());
  return std::make_shared<const Domain>(std::move(*domain));
}

/// What runs over the domains of the tests and samples say, all words together.
struct Heard {
  std::array<std::size_t, kEventKindCount> kinds{};
  std::array<std::size_t, kRuleCount> rules{};
  std::array<std::size_t, kRefusalCount> refusals{};
};

template <class Check>
void listen(const support::DomainPtr& domain, const Settings& settings, Heard& heard, const Check& check) {
  MeshState state = support::start(domain, settings);
  std::vector<Event> events;
  Journal journal{&events};
  advance(state, Grain::all, journal);
  for (const Event& event : events) {
    ++heard.kinds[static_cast<std::size_t>(event.kind)];
    ++heard.rules[static_cast<std::size_t>(event.rule)];
    ++heard.refusals[static_cast<std::size_t>(event.refusal)];
    check(event, state);
  }
}

/// How many ids of that kind there can be at the end of the run.
std::size_t countOf(Names what, const MeshState& state) {
  switch (what) {
    case Names::triangle:
      return state.mesh.nextId.n;
    case Names::vertex:
      return state.mesh.points.size();
    case Names::cell:
      return state.tree.cells.size();
    case Names::constraint:
      return state.constraints.size();
    case Names::curve:
      return state.domain->curves.size() + state.domain->density.size();
    case Names::boundary_edge:
      return state.mesh.edges.size();
    case Names::boundary_point:
      return state.boundary.size();
    default:
      return kNoId;
  }
}

TEST(Vocabulary, EachWordIsSaidByARunAndIsTrueOfIt) {
  Heard heard;
  const auto check = [](const Event& e, const MeshState& state) {
    const KindWords& words = wordsOf(e.kind);
    const auto isOne = [&](Names what, std::uint32_t id) {
      return what == Names::nothing || what == Names::changes || id == kNoId || id < countOf(what, state);
    };
    const std::string said = fmt::format("{}, {}", words.name, name(e.rule));
    EXPECT_TRUE(isOne(words.subject, e.subject)) << said << ": subject " << e.subject;
    EXPECT_TRUE(isOne(otherOf(e), e.other)) << said << ": other " << e.other;
    EXPECT_TRUE(words.created != Names::nothing || e.createdCount == 0) << said;
    EXPECT_TRUE(e.vertex == kNoId || e.vertex < state.mesh.points.size()) << said;
    const bool ofVertex = does(e, kInserts) || does(e, kMoves) || wordsOf(e.rule).ofVertices;
    EXPECT_TRUE(!ofVertex || e.vertex != kNoId) << said;
  };
  for (const char* const file : {"koch5", "cracked_plate", "notch_over_wall", "blunt_body"})
    listen(support::domainAt(support::testData() / (std::string(file) + ".json")), support::withoutOptimiser(), heard,
           check);
  listen(support::domainAt(support::samples() / "narrow_gap.json"), {}, heard, check);
  Settings few;
  few.maxTriangles = 1000;
  listen(support::domainAt(support::testData() / "blunt_body.json"), few, heard, check);
  Settings wide = support::withoutOptimiser();
  wide.theta = 10.0;  // so far that some turns would turn a triangle over
  listen(support::domainAt(support::testData() / "perforated_plate.json"), wide, heard, check);
  listen(domainOf(R"({"outer": [[0, 0], [10, 0], [10, 10], [0, 10]], "min_edge_length": 0.5,
                      "density": [{"at": [3, 4], "length": 0.5}]})"),
         {}, heard, check);
  // Chains that leave one point at nine degrees.
  listen(domainOf(R"({"outer": [[-10, -10], [10, -10], [10, 10], [-10, 10]], "min_edge_length": 0.5,
                      "segments": [[[0, 0], [3, 0]], [[0, 0], [3, 0.5]], [[0, 0], [3, 1]], [[0, 0], [3, 1.5]]]})"),
         {}, heard, check);
  for (const Placement placement : {Placement::rebay, Placement::size_optimal, Placement::tiling, Placement::spokes}) {
    Settings rows = support::best(Dial::acute);
    rows.placement = placement;
    listen(domainOf(support::kNotched), rows, heard, check);
    rows.maxRank = 1;
    listen(domainOf(R"({"outer": [[0, 0], [8, 0], [8, 8], [0, 8]], "min_edge_length": 0.25})"), rows, heard, check);
  }
  listen(support::domainAt(support::testData() / "blunt_body.json"), support::best(), heard, check);
  Settings bare = support::withoutStep6();  // as bad a mesh as the steps leave
  bare.optimise = true;
  bare.dial = Dial::acute;
  listen(support::domainAt(support::testData() / "cracked_plate.json"), bare, heard, check);
  for (int k = 0; k < kEventKindCount; ++k) EXPECT_GT(heard.kinds[static_cast<std::size_t>(k)], 0u) << name(kindAt(k));
  for (int k = 0; k < kRuleCount; ++k) EXPECT_GT(heard.rules[static_cast<std::size_t>(k)], 0u) << name(ruleAt(k));
  for (int k = 0; k < kRefusalCount; ++k) {
    if (refusalAt(k) == Refusal::budget_spent) continue;  // limits_test spends it, by hand
    if (refusalAt(k) == Refusal::too_thin) continue;      // smooth_test has stars that call for it
    EXPECT_GT(heard.refusals[static_cast<std::size_t>(k)], 0u) << name(refusalAt(k));
  }
}

/// F9 stops where History lists an event, and nowhere else.
TEST(Vocabulary, BreakpointsAndHistoryAgreeOnWhatIsAboutAnElement) {
  MeshState state = support::start(support::domainAt(support::testData() / "cracked_plate.json"));
  std::vector<Event> events;
  Journal journal{&events};
  advance(state, Grain::all, journal);
  const RunningQuality quality;
  const auto expectAlike = [&](std::string_view word, Ref ref) {
    const Result<Condition> condition = Condition::compile(std::string(word) + " == " + std::to_string(ref.id));
    ASSERT_TRUE(condition.ok());
    std::vector<std::size_t> stops;
    for (std::size_t k = 0; k < events.size(); ++k)
      if (condition->holds({state, events[k], quality})) stops.push_back(k);
    EXPECT_EQ(stops, eventsAbout(Events(events), ref)) << word << " " << ref.id;
  };
  for (std::uint32_t id = 0; id < state.mesh.nextId.n; id += state.mesh.nextId.n / 97)
    expectAlike("triangle", {Ref::Kind::triangle, id});
  for (std::uint32_t id = 0; id < state.mesh.points.size(); id += 211) expectAlike("vertex", {Ref::Kind::vertex, id});
  for (std::uint32_t id = 0; id < state.tree.cells.size(); id += 101) expectAlike("cell", {Ref::Kind::cell, id});
  // The triangles over whose edge the first step 5 reaches, and for which repair first splits the boundary.
  for (const Rule rule : {Rule::step5, Rule::repair})
    for (const Event& e : events)
      if (e.rule == rule && e.other != kNoId) {
        expectAlike("triangle", {Ref::Kind::triangle, e.other});
        break;
      }
}

}  // namespace
}  // namespace triscope::vocabulary_test
