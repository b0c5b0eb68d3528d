// Every event says what happened and why, with its own figures.
#include "core/explain/caption.h"

#include <gtest/gtest.h>

#include "core/base/counted.h"
#include "core/domain/read.h"
#include "core/method/pipeline.h"

namespace triscope::caption_test {
namespace {

bool contains(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

TEST(Caption, SaysWhyStepThreeInserted) {
  Event e;
  e.kind = EventKind::vertex_inserted;
  e.stage = Stage::step3;
  e.rule = Rule::step3;
  e.subject = 5790;
  e.vertex = 611;
  e.measured = 2.31;
  e.limit = 1.98;
  e.removedCount = 4;
  e.createdCount = 6;
  EXPECT_EQ(captionOf(e),
            "Step 3 put vertex 611 at the circumcentre of triangle 5790: its circumradius R = 2.31 is not below its "
            "shortest edge e = 1.98. 4 triangles gave way to 6.");
}

TEST(Caption, SaysWhyAPointWasRefused) {
  Event e;
  e.kind = EventKind::vertex_refused;
  e.stage = Stage::front1;
  e.rule = Rule::first_front;
  e.refusal = Refusal::too_close;
  e.measured = 0.5;
  e.limit = 0.7;
  e.at = {1.0, 2.0};
  const std::string text = captionOf(e);
  EXPECT_TRUE(contains(text, "refused")) << text;
  EXPECT_TRUE(contains(text, "0.5 < 0.7")) << text;
  EXPECT_TRUE(contains(text, "(1, 2)")) << text;
}

TEST(Caption, EveryKindAndRuleIsASentence) {
  for (int kind = 0; kind <= static_cast<int>(EventKind::failure); ++kind)
    for (int rule = 0; rule < kRuleCount; ++rule) {
      Event e;
      e.kind = static_cast<EventKind>(kind);
      e.rule = static_cast<Rule>(rule);
      e.refusal = Refusal::star_worse;
      e.subject = e.other = e.vertex = e.created = 7;
      const std::string text = captionOf(e);
      ASSERT_FALSE(text.empty());
      EXPECT_TRUE(text.back() == '.') << text;
      EXPECT_FALSE(contains(text, "4294967295")) << text;
    }
}

TEST(Caption, NumbersAreInTheirRightNumber) {
  EXPECT_EQ(counted(0, "time", "times"), "0 times");
  EXPECT_EQ(counted(1, "time", "times"), "1 time");
  EXPECT_EQ(counted(106431, "decision", "decisions"), "106\u2009431 decisions");
  Event e;
  e.kind = EventKind::vertex_inserted;
  e.rule = Rule::initial;
  e.vertex = 1;
  e.createdCount = 1;
  EXPECT_TRUE(contains(captionOf(e), "It made 1 triangle.")) << captionOf(e);
  MeshState state;
  state.stage = Stage::finished;
  state.tick = 106431;
  Quality quality;
  quality.triangles = 1;
  EXPECT_TRUE(contains(summaryOf(state, quality), "after 106\u2009431 decisions: 1 triangle, none of them obtuse"));
}

TEST(Caption, SummaryNamesTheFigures) {
  Result<Domain> domain = parseDomain(R"({"outer": [[0,0],[4,0],[4,4],[0,4]], "min_edge_length": 1})", "square");
  ASSERT_TRUE(domain.ok());
  Result<MeshState> state = begin(std::make_shared<const Domain>(*domain), Settings{});
  ASSERT_TRUE(state.ok());
  EXPECT_TRUE(contains(summaryOf(*state, {}), "comes next"));
  Journal deaf;
  advance(*state, Grain::all, deaf);
  const Quality quality = measure(state->mesh);
  const std::string text = summaryOf(*state, quality);
  EXPECT_TRUE(contains(text, std::to_string(quality.triangles) + " triangles")) << text;
}

}  // namespace
}  // namespace triscope::caption_test
