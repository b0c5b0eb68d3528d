// History of one element, from birth to death.
#include <fmt/format.h>

#include <algorithm>

#include "core/explain/answer.h"
#include "core/explain/shape_story.h"
#include "core/explain/why.h"
#include "core/words/vocabulary.h"

namespace triscope {
namespace {

bool sameRefusal(const Event& a, const Event& b) {
  return does(a, kRefuses) && a.kind == b.kind && a.rule == b.rule && a.refusal == b.refusal;
}

/// What an event made of the triangle's own shape; nothing when it moved no corner.
std::string changeOf(const ShapeStory& story, std::size_t event) {
  const auto move = std::find_if(story.moves.begin(), story.moves.end(),
                                 [event](const ShapeChange& change) { return change.event == event; });
  if (move == story.moves.end()) return {};
  return fmt::format(" This triangle's went from {:.4g} to {:.4g}.", move->before, move->after);
}

}  // namespace

std::vector<Line> historyOf(Events events, Ref ref, const TriangleFacts& facts) {
  Answer answer(events);
  std::vector<std::size_t> indices = eventsAbout(events, ref);
  const std::optional<std::size_t> birth = birthOf(events, ref);
  if (!birth) answer.say(withoutBirth(events, ref));
  std::optional<ShapeStory> story;
  if (ref.kind == Ref::Kind::triangle) {
    if (facts.death) indices.erase(std::remove(indices.begin(), indices.end(), *facts.death), indices.end());
    if (birth) story = shapeStoryOf(events, *birth, facts);
    if (story)
      for (const ShapeChange& move : story->moves) indices.push_back(move.event);
    std::sort(indices.begin(), indices.end());
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
  }
  for (std::size_t k = 0; k < indices.size();) {
    std::size_t last = k;
    while (last + 1 < indices.size() && sameRefusal(events[indices[k]], events[indices[last + 1]])) ++last;
    std::string text = told(events, indices[last]);
    if (last > k) text += fmt::format(" The last of {} times since event {}.", last - k + 1, indices[k]);
    if (story) text += changeOf(*story, indices[last]);
    answer.say(text);
    k = last + 1;
  }
  if (facts.death) answer.say(ending(events, *facts.death));
  return answer.take();
}

}  // namespace triscope
