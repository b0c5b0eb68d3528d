#include "core/explain/why.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/capitalised.h"
#include "core/base/counted.h"
#include "core/explain/answer.h"
#include "core/explain/caption.h"
#include "core/explain/shape_story.h"

namespace triscope {
namespace {

constexpr std::size_t kCauses = 4;       // of a triangle or vertex, told before the reader has to follow a link
constexpr std::size_t kCellCauses = 64;  // a density rank comes from a neighbour's; as many as there are ranks

/// "It came with triangles 9000 to 9005." Nothing for a vertex.
std::string siblings(const Event& birth, Ref ref) {
  if (ref.kind != Ref::Kind::triangle && ref.kind != Ref::Kind::cell) return {};
  if (birth.createdCount < 2) return {};
  return fmt::format("{} is one of {}s {} to {}, which came together.", capitalised(nameOf(ref)), nameOf(ref.kind),
                     birth.created, birth.created + birth.createdCount - 1);
}

/// What became of a vertex after its birth.
void tellMoves(Events events, std::uint32_t vertex, std::size_t birth, Answer& answer) {
  std::size_t moves = 0;
  std::size_t kept = 0;
  std::size_t last = 0;
  std::optional<std::size_t> removal;
  const auto may = [vertex](const Mentioned& mentioned) { return mentioned.vertex.has(vertex); };
  for (std::size_t k = events.next(birth + 1, may); k < events.size(); k = events.next(k + 1, may)) {
    const Event& e = events.peek(k);
    if (e.vertex != vertex) continue;
    if (e.kind == EventKind::vertex_kept) ++kept;
    if (e.kind == EventKind::vertex_removed) removal = k;
    if (e.kind != EventKind::vertex_moved) continue;
    ++moves;
    last = k;
  }
  if (moves > 0)
    answer.say(fmt::format("It has moved {} since, last by event {}: {}",
                           moves == 1 ? "once" : fmt::format("{} times", moves), last, captionOf(events[last])));
  if (kept > 0)
    answer.say(fmt::format("{} {} of it {} refused.", kept, kept == 1 ? "move" : "moves", kept == 1 ? "was" : "were"));
  if (removal) answer.tell(*removal, 1);
}

/// What moves have made of a triangle since its birth.
void tellShape(const ShapeStory& story, Answer& answer) {
  std::string text = fmt::format("Its aspect ratio R/r was {:.4g} when it was made", story.atBirth);
  if (story.moves.empty()) {
    answer.say(text + " and is the same now: no corner has moved.");
    return;
  }
  const auto change = [](const ShapeChange& move) { return std::fabs(move.after - move.before); };
  const auto most = std::max_element(story.moves.begin(), story.moves.end(),
                                     [&](const auto& a, const auto& b) { return change(a) < change(b); });
  text += fmt::format(" and is {:.4g} now, after {}", story.moves.back().after,
                      counted(story.moves.size(), "move of its corners", "moves of its corners"));
  if (story.moves.size() > 1) text += ", the largest";
  answer.say(text + fmt::format(" by event {} ({:.4g} to {:.4g}).", most->event, most->before, most->after));
}

}  // namespace

Line lineOf(Events events, std::size_t index) { return linked(told(events, index)); }

std::vector<Line> why(Events events, Ref ref, const TriangleFacts& facts) {
  Answer answer(events);
  const std::optional<std::size_t> birth = birthOf(events, ref);
  const bool cell = ref.kind == Ref::Kind::cell;
  if (cell) {  // its density first, back to the constraint; then its size
    const std::optional<std::size_t> reason = reasonFor(events, ref, events.size());
    if (reason) answer.tell(*reason, kCellCauses);
  }
  if (ref.kind == Ref::Kind::triangle && birth) {
    if (const auto story = shapeStoryOf(events, *birth, facts)) tellShape(*story, answer);
  }
  if (birth) {
    answer.tell(*birth, cell ? 2 : kCauses);
    if (ref.kind != Ref::Kind::event) answer.say(siblings(events[*birth], ref));
  } else {
    answer.say(withoutBirth(events, ref));
  }
  if (ref.kind == Ref::Kind::vertex && birth) tellMoves(events, ref.id, *birth, answer);
  return answer.take();
}

}  // namespace triscope
