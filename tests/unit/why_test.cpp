// Why, Why not and History, held against the recorded runs of samples: what is named exists, and the values named do
// satisfy the rule named.
#include "core/explain/why.h"

#include <gtest/gtest.h>

#include <memory>
#include <set>
#include <string>

#include "core/explain/life.h"
#include "core/geometry/circumcircle.h"
#include "core/method/stages/insertion_rules.h"
#include "core/quality/quality.h"
#include "core/words/vocabulary.h"
#include "support/recorded.h"
#include "support/runs.h"

namespace triscope::why_test {
namespace {

const char* const kSamples[] = {"annulus", "l_shape", "blunt_body", "cracked_plate", "narrow_gap"};

/// Steps 1-5 propose where the measured value is not below the limit, up to rounding.
void expectRuleHolds(const Event& e) {
  if (e.rule < Rule::step1 || e.rule > Rule::step5) return;
  EXPECT_GE(e.measured, e.limit * (1.0 - 1e-8)) << name(e.rule);
  EXPECT_GT(e.limit, 0.0);
}

void expectLinksResolve(const support::Recorded& run, const std::vector<Line>& answer, Ref ref) {
  std::set<std::string> texts;
  ASSERT_FALSE(answer.empty()) << nameOf(ref);
  for (const Line& line : answer) {
    const std::string text = textOf(line);
    EXPECT_TRUE(texts.insert(text).second) << nameOf(ref) << " is told twice: " << text;
    EXPECT_EQ(text.find("4294967295"), std::string::npos) << text;
    ASSERT_FALSE(text.empty());
    EXPECT_EQ(text.back(), '.') << text;
    for (const Span& span : line) {
      if (!span.link) continue;
      const Ref to = *span.link;
      EXPECT_NE(span.text.find(std::to_string(to.id)), std::string::npos) << text;
      switch (to.kind) {
        case Ref::Kind::event:
          EXPECT_LT(to.id, run.events.size()) << text;
          break;
        case Ref::Kind::triangle:
          EXPECT_TRUE(to.id < 2 || birthOf(run.events, to)) << text;
          break;
        case Ref::Kind::vertex:
          EXPECT_TRUE(to.id < 4 || birthOf(run.events, to)) << text;
          break;
        case Ref::Kind::cell:
          EXPECT_LT(to.id, run.end.tree.cells.size()) << text;
          break;
      }
    }
  }
}

TEST(Links, AreCutOutOfText) {
  const Line line = linked("Event 12: triangles 3, 4 and 5 met Vertex 7 and 8 cells; cell 2.5 at vertexes 9.");
  std::string links;
  for (const Span& span : line)
    if (span.link) links += nameOf(*span.link) + ";";
  EXPECT_EQ(links, "event 12;triangle 3;triangle 4;triangle 5;vertex 7;");
  EXPECT_EQ(textOf(line), "Event 12: triangles 3, 4 and 5 met Vertex 7 and 8 cells; cell 2.5 at vertexes 9.");
}

TEST(Links, ReadWhatTheCommandLineGives) {
  EXPECT_EQ(refFrom("triangle=5821"), (Ref{Ref::Kind::triangle, 5821}));
  EXPECT_EQ(refFrom("cell=0"), (Ref{Ref::Kind::cell, 0}));
  for (const char* wrong : {"", "triangle", "triangle=", "triangle=x", "triangle=1x", "edge=1", "vertex=-1",
                            "vertex=99999999999", "triangle=1.5"})
    EXPECT_FALSE(refFrom(wrong).has_value()) << wrong;
}

TEST(Why, BirthIsFoundLikeByLookingAtEveryEvent) {
  for (const char* const sample : kSamples) {
    const support::Recorded& run = support::runOf(sample);
    const auto check = [&](Ref::Kind kind, std::uint32_t count, std::uint32_t first) {
      std::vector<std::optional<std::size_t>> byBrute(count);
      for (std::size_t k = 0; k < run.events.size(); ++k) {
        const Event& e = run.events[k];
        const bool split = e.kind == EventKind::cell_split;
        if (kind == Ref::Kind::vertex && (e.kind == EventKind::vertex_inserted || e.kind == EventKind::edge_split))
          byBrute.at(e.vertex) = k;
        if (kind != Ref::Kind::vertex && split == (kind == Ref::Kind::cell))
          for (std::uint32_t i = 0; i < e.createdCount; ++i) byBrute.at(e.created + i) = k;
      }
      for (std::uint32_t id = 0; id < count; ++id) {
        ASSERT_EQ(birthOf(run.events, {kind, id}), byBrute[id]) << sample << " " << nameOf(Ref{kind, id});
        ASSERT_EQ(byBrute[id].has_value(), id >= first) << sample << " " << nameOf(Ref{kind, id});
      }
      EXPECT_FALSE(birthOf(run.events, {kind, count}));
    };
    check(Ref::Kind::triangle, run.end.mesh.nextId.n, 2);
    check(Ref::Kind::vertex, static_cast<std::uint32_t>(run.end.mesh.points.size()), 4);
    check(Ref::Kind::cell, static_cast<std::uint32_t>(run.end.tree.cells.size()), 1);
  }
}

TEST(Why, EveryVertexIsExplainedByARuleThatItsValuesSatisfy) {
  for (const char* const sample : kSamples) {
    const support::Recorded& run = support::runOf(sample);
    std::size_t bySteps = 0;
    for (std::uint32_t v = 4; v < run.end.mesh.points.size(); ++v) {
      const Ref ref{Ref::Kind::vertex, v};
      const auto birth = birthOf(run.events, ref);
      ASSERT_TRUE(birth) << sample << " vertex " << v;
      const Event& e = run.events[*birth];
      ASSERT_EQ(e.vertex, v);
      EXPECT_NE(e.rule, Rule::none);
      expectRuleHolds(e);
      if (e.rule >= Rule::step1 && e.rule <= Rule::step5) ++bySteps;
      const std::vector<Line> answer = why(run.events, ref);
      expectLinksResolve(run, answer, ref);
      // The first line tells the birth and names the vertex.
      const std::string first = textOf(answer.front());
      EXPECT_EQ(first.find("Event " + std::to_string(*birth) + ": "), 0u) << first;
      EXPECT_NE(first.find(std::to_string(v)), std::string::npos) << first;
    }
    EXPECT_GT(bySteps, 0u) << sample;
  }
}

TEST(Why, TheFiguresOfStepThreeAreThoseOfTheTriangleAtThatMoment) {
  const support::Recorded& run = support::runOf("l_shape");
  Journal deaf;
  std::size_t checked = 0;
  for (std::size_t k = 0; k < run.events.size() && checked < 25; ++k) {
    const Event& e = run.events[k];
    if (e.rule != Rule::step3 || e.kind != EventKind::vertex_inserted) continue;
    const MeshState before = run.history.seek(run.tickAt[k] - 1, deaf);
    const Slot slot = slotOf(before.mesh, TriangleId(e.subject));
    ASSERT_TRUE(slot.exists()) << "event " << k;
    const Triangle& t = triangleAt(before.mesh, slot);
    const Point a = pointOf(before.mesh, t.v[0]), b = pointOf(before.mesh, t.v[1]), c = pointOf(before.mesh, t.v[2]);
    EXPECT_DOUBLE_EQ(e.measured, std::sqrt(circumcircle(a, b, c).squaredRadius));
    EXPECT_DOUBLE_EQ(e.limit, std::min({distance(a, b), distance(b, c), distance(c, a)}));
    const std::string text = textOf(why(run.events, {Ref::Kind::vertex, e.vertex}).front());
    EXPECT_NE(text.find("triangle " + std::to_string(e.subject)), std::string::npos) << text;
    EXPECT_NE(text.find("shortest edge e"), std::string::npos) << text;
    ++checked;
  }
  EXPECT_GT(checked, 3u);
}

TEST(Why, EveryTriangleIsExplained) {
  for (const char* const sample : kSamples) {
    const support::Recorded& run = support::runOf(sample);
    // Each answer reads all events: of a large run a part of the triangles.
    const std::size_t step = 1 + run.events.size() / 4000;
    for (std::size_t n = 0; n < run.end.mesh.triangles.size(); n += step) {
      const Slot slot(n);
      if (!run.end.mesh.alive(slot)) continue;
      const Ref ref{Ref::Kind::triangle, run.end.mesh.ids[slot].word()};
      const auto birth = birthOf(run.events, ref);
      ASSERT_TRUE(birth) << sample << " " << nameOf(ref);
      expectRuleHolds(run.events[*birth]);
      expectLinksResolve(run, why(run.events, ref), ref);
      const TriangleFacts facts = *factsOf(run.end.mesh, TriangleId(ref.id));
      expectLinksResolve(run, whyNot(run.events, ref.id, facts), ref);
      expectLinksResolve(run, historyOf(run.events, ref, facts), ref);
    }
  }
}

TEST(Why, EveryCellLeadsBackToAConstraint) {
  for (const char* const sample : kSamples) {
    const support::Recorded& run = support::runOf(sample);
    for (std::uint32_t cell = 0; cell < run.end.tree.cells.size(); ++cell) {
      const Ref ref{Ref::Kind::cell, cell};
      const std::vector<Line> answer = why(run.events, ref);
      expectLinksResolve(run, answer, ref);
      const bool ranked = std::any_of(run.events.begin(), run.events.end(), [&](const Event& e) {
        return e.kind == EventKind::cell_ranked && e.subject == cell;
      });
      if (!ranked) continue;
      std::string all;
      for (const Line& line : answer) all += textOf(line) + "\n";
      EXPECT_NE(all.find(" took density rank "), std::string::npos) << sample << " cell " << cell << ":\n" << all;
      EXPECT_NE(all.find("An edge length of"), std::string::npos) << sample << " cell " << cell << ":\n" << all;
    }
  }
}

TEST(WhyNot, NamesEveryRuleAndRecordedRefusals) {
  const support::Recorded run =
      support::record(support::domainAt(support::testData() / "cracked_plate.json"), 1u << 22);
  std::size_t refused = 0;
  for (std::size_t k = 0; k < run.events.size() && refused < 40; ++k) {
    const Event& e = run.events[k];
    if (e.kind != EventKind::vertex_refused || e.rule < Rule::step1 || e.rule > Rule::step5) continue;
    expectRuleHolds(e);
    std::string all;
    for (const Line& line : whyNot(run.events, e.subject)) all += textOf(line) + "\n";
    EXPECT_NE(all.find(std::string(describe(e.refusal))), std::string::npos) << all;
    const bool mended = all.find(describe(Rule::repair)) != std::string::npos;
    EXPECT_TRUE(mended || all.find("Repair") != std::string::npos) << all;
    for (const char* rule : {"Step 1", "Step 2", "Step 3", "Step 4", "Step 5", "Obtuse angle", "Shared edge"})
      EXPECT_NE(all.find(rule), std::string::npos) << rule << " in\n" << all;
    ++refused;
  }
  EXPECT_GT(refused, 0u);
}

TEST(WhyNot, ARuleIsSilentExactlyWhereItsConditionDoesNotHold) {
  // Right after the last round of steps 1-5: nothing has been moved since the rules had their last look.
  for (const char* const sample : {"annulus", "l_shape", "cracked_plate"}) {
    MeshState state = support::start(support::domainAt(support::samples() / (std::string(sample) + ".json")));
    std::vector<Event> events;
    Journal journal{&events};
    advanceUntil(state, Stage::repair, ~std::uint64_t{0}, journal);
    ASSERT_EQ(state.stage, Stage::refine);
    const Mesh& mesh = state.mesh;
    std::size_t silent = 0;
    for (const Slot slot : mesh.triangles.keys()) {
      if (!mesh.alive(slot)) continue;
      for (const Line& line : whyNot(events, idOf(mesh, slot).word())) {
        const std::string text = textOf(line);
        for (int step = 2; step <= 5; ++step) {
          const auto stage = static_cast<Stage>(static_cast<int>(Stage::step1) + step - 1);
          Proposal proposal;
          LeafPath path;
          if (text.find("Step " + std::to_string(step) + " proposed nothing") == 0) {
            EXPECT_FALSE(proposes(stage, state, slot, path, proposal)) << sample << ": " << text;
            ++silent;
          } else if (text.find(": Step " + std::to_string(step) + " proposed a vertex") != std::string::npos) {
            EXPECT_TRUE(proposes(stage, state, slot, path, proposal)) << sample << ": " << text;
          }
        }
      }
    }
    EXPECT_GT(silent, 100u) << sample;
  }
}

TEST(WhyNot, WhatIsNotThereIsSaidToBeNotThere) {
  const support::Recorded& run = support::runOf("annulus");
  EXPECT_EQ(textOf(whyNot(run.events, 4000000000u).front()), "There is no triangle 4000000000 up to here.");
  EXPECT_EQ(textOf(why(run.events, {Ref::Kind::vertex, 99999}).front()), "There is no vertex 99999 up to here.");
  EXPECT_EQ(textOf(historyOf({}, {Ref::Kind::triangle, 0}).front()), "There is no triangle 0 up to here.");
  EXPECT_NE(textOf(why(run.events, {Ref::Kind::triangle, 1}).front()).find("box"), std::string::npos);
  EXPECT_NE(textOf(why(run.events, {Ref::Kind::cell, 0}).front()).find("root"), std::string::npos);
}

TEST(HistoryOf, TellsEveryEventAboutAnElementInOrder) {
  const support::Recorded& run = support::runOf("l_shape");
  for (std::uint32_t v = 4; v < run.end.mesh.points.size(); v += 7) {
    const Ref ref{Ref::Kind::vertex, v};
    std::size_t moves = 0;
    for (const Event& e : run.events)
      if (e.vertex == v && e.kind == EventKind::vertex_moved) ++moves;
    std::size_t told = 0;
    for (const Line& line : historyOf(run.events, ref))
      if (textOf(line).find(" moved by ") != std::string::npos) ++told;
    EXPECT_EQ(told, moves);
  }
}

TEST(Why, APackedLogGivesTheSameAnswers) {
  // Blocks of it are passed by; a list is looked through in full.
  const support::Recorded& run = support::runOf("l_shape");
  const EventLog log(run.events);
  const auto textsOf = [](const std::vector<Line>& lines) {
    std::vector<std::string> texts;
    for (const Line& line : lines) texts.push_back(textOf(line));
    return texts;
  };
  std::size_t found = 0;
  for (const Ref::Kind kind : {Ref::Kind::vertex, Ref::Kind::triangle, Ref::Kind::cell}) {
    for (std::uint32_t id = 0; id < run.end.mesh.nextId.n; id += 11) {
      const Ref ref{kind, id};
      const std::vector<std::size_t> about = eventsAbout(log, ref);
      ASSERT_EQ(about, eventsAbout(run.events, ref)) << nameOf(ref);
      ASSERT_EQ(textsOf(why(log, ref)), textsOf(why(run.events, ref))) << nameOf(ref);
      const TriangleFacts facts = kind == Ref::Kind::triangle
                                      ? factsOf(run.end.mesh, TriangleId(id)).value_or(TriangleFacts{})
                                      : TriangleFacts{};
      ASSERT_EQ(textsOf(historyOf(log, ref, facts)), textsOf(historyOf(run.events, ref, facts))) << nameOf(ref);
      if (kind == Ref::Kind::triangle) {
        ASSERT_EQ(textsOf(whyNot(log, id, facts)), textsOf(whyNot(run.events, id, facts))) << nameOf(ref);
      }
      found += about.size();
    }
  }
  EXPECT_GT(found, 500u);
}

}  // namespace
}  // namespace triscope::why_test
