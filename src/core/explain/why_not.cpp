// Why not: what the rules proposed for a triangle, and why nothing came of it.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/base/capitalised.h"
#include "core/explain/answer.h"
#include "core/explain/why.h"
#include "core/method/method.h"
#include "core/words/vocabulary.h"

namespace triscope {
namespace {

/// Proposals of one rule that had the same outcome; `last` is the latest event of them.
struct Outcomes {
  std::size_t first;
  std::size_t last;
  std::size_t count;
};

/// What one look through the triangle's life found.
struct Review {
  std::array<std::vector<Outcomes>, kRuleCount> outcomes;     // by rule
  std::array<std::optional<std::size_t>, kStageCount> ended;  // by stage: the last event that ended it, of its life
  std::array<bool, kStageCount> endedBefore{};                // by stage: it ended before the triangle was made
  std::array<bool, kStageCount> begun{};                      // by stage
};

/// True when the proposal is for the triangle, or for one of its corners.
bool isFor(const Event& e, std::uint32_t triangle, const TriangleFacts& facts) {
  if (wordsOf(e.rule).ofVertices)
    return std::find(facts.corners.begin(), facts.corners.end(), e.vertex) != facts.corners.end();
  const Named origin = originOf(e);
  return origin.what == Names::triangle && origin.id == triangle;
}

bool sameOutcome(const Event& a, const Event& b) {
  const bool move = wordsOf(a.kind).from;
  return a.kind == b.kind && a.refusal == b.refusal && (!move || a.vertex == b.vertex);
}

void add(Events events, std::size_t index, std::vector<Outcomes>& list) {
  const Event now = events.peek(index);
  const auto same =
      std::find_if(list.begin(), list.end(), [&](const Outcomes& o) { return sameOutcome(events.peek(o.first), now); });
  if (same == list.end()) {
    list.push_back({index, index, 1});
  } else {
    same->last = index;
    ++same->count;
  }
}

Review reviewOf(Events life, std::size_t birth, std::uint32_t triangle, const TriangleFacts& facts) {
  Review review;
  const auto mayEnd = [](const Mentioned& mentioned) {
    return mentioned.has(EventKind::stage_finished) || mentioned.has(EventKind::stage_begun);
  };
  for (std::size_t k = life.next(0, mayEnd); k < birth; k = life.next(k + 1, mayEnd)) {
    const Event& e = life.peek(k);
    if (e.kind == EventKind::stage_begun) review.begun[static_cast<std::size_t>(e.stage)] = true;
    if (e.kind == EventKind::stage_finished) review.endedBefore[static_cast<std::size_t>(e.stage)] = true;
  }
  const auto may = [&](const Mentioned& mentioned) {
    return mayEnd(mentioned) || mayBeAbout(mentioned, {Ref::Kind::triangle, triangle}) ||
           std::any_of(facts.corners.begin(), facts.corners.end(), [&](auto v) { return mentioned.vertex.has(v); });
  };
  for (std::size_t k = life.next(birth, may); k < life.size(); k = life.next(k + 1, may)) {
    const Event& e = life.peek(k);
    if (e.kind == EventKind::stage_begun) review.begun[static_cast<std::size_t>(e.stage)] = true;
    if (e.kind == EventKind::stage_finished) review.ended[static_cast<std::size_t>(e.stage)] = k;
    if (does(e, kProposes) && isFor(e, triangle, facts))
      add(life, k, review.outcomes[static_cast<std::size_t>(e.rule)]);
  }
  return review;
}

/// Whether the run passed the stage by, or may do so: one that optimises is often left out.
bool isLeftOut(const Review& review, Stage stage) {
  const auto* const own = review.begun.begin() + static_cast<std::ptrdiff_t>(stage);
  return !*own && (optimisesMesh(stage) || std::find(own, review.begun.end(), true) != review.begun.end());
}

/// Of a rule that proposed nothing: that it had a look and found nothing to do, or why it had none.
std::string silence(Events life, const Review& review, const RuleWords& words, bool gone) {
  const std::string rule = capitalised(words.name);
  if (const auto end = review.ended[static_cast<std::size_t>(words.stage)]) {
    const std::string round = inRounds(words.stage) ? turnBehind(words.stage, life[*end].round) : "";
    return fmt::format("{} proposed nothing up to its end at event {}{}: {}.", rule, *end, round, words.silent);
  }
  const bool before = review.endedBefore[static_cast<std::size_t>(words.stage)];
  return fmt::format("{} has proposed nothing: {}.", rule,
                     before ? "it was over before the triangle was made"
                     : gone ? "the triangle was gone before it came to its end"
                            : "it has not come to its end yet");
}

}  // namespace

std::vector<Line> whyNot(Events events, std::uint32_t triangle, const TriangleFacts& facts) {
  Answer answer(events);
  const Ref ref{Ref::Kind::triangle, triangle};
  const std::optional<std::size_t> birth = birthOf(events, ref);
  if (!birth && triangle > 1) {
    answer.say(withoutBirth(events, ref));
    return answer.take();
  }
  const Events life = facts.death ? events.first(*facts.death + 1) : events;
  const Review review = reviewOf(life, birth.value_or(0), triangle, facts);
  for (std::size_t k = 0; k < review.outcomes.size(); ++k) {
    const RuleWords& words = wordsOf(static_cast<Rule>(k));
    if (words.ofVertices && facts.corners[0] == kNoId) continue;
    for (const Outcomes& outcome : review.outcomes[k]) {
      answer.say(told(events, outcome.last) +
                 (outcome.count > 1 ? fmt::format(" The last of {} times.", outcome.count) : std::string()));
    }
    if (words.silent.empty() || isLeftOut(review, words.stage)) continue;
    if (review.outcomes[k].empty()) answer.say(silence(life, review, words, facts.death.has_value()));
  }
  if (facts.death) answer.say(ending(events, *facts.death));
  return answer.take();
}

}  // namespace triscope
