// History of one element, from birth to death.
#include <fmt/format.h>

#include <algorithm>

#include "core/debug/answer.h"
#include "core/debug/why.h"

namespace triscope {
namespace {

bool isRefusal(const Event& e) { return e.kind == EventKind::vertex_kept || e.kind == EventKind::vertex_refused; }

bool alike(const Event& a, const Event& b) {
  return isRefusal(a) && a.kind == b.kind && a.rule == b.rule && a.refusal == b.refusal;
}

/// Adds the moves of a triangle's corners during its life.
void addMoves(Events events, const TriangleFacts& facts, std::vector<std::size_t>& indices) {
  if (indices.empty()) return;
  const std::size_t end = facts.death ? *facts.death : events.size();
  const auto may = [&](const Mentioned& mentioned) {
    return mentioned.has(EventKind::vertex_moved) &&
           std::any_of(facts.corners.begin(), facts.corners.end(), [&](auto v) { return mentioned.vertex.has(v); });
  };
  for (std::size_t k = events.next(indices.front() + 1, may); k < end; k = events.next(k + 1, may)) {
    const Event& e = events.peek(k);
    if (e.kind != EventKind::vertex_moved) continue;
    if (std::find(facts.corners.begin(), facts.corners.end(), e.vertex) != facts.corners.end()) indices.push_back(k);
  }
}

}  // namespace

std::vector<Line> historyOf(Events events, Ref ref, const TriangleFacts& facts) {
  Answer answer(events);
  std::vector<std::size_t> indices = eventsAbout(events, ref);
  if (!birthOf(events, ref)) answer.say(withoutBirth(events, ref));
  if (ref.kind == Ref::Kind::triangle) {
    if (facts.death) indices.erase(std::remove(indices.begin(), indices.end(), *facts.death), indices.end());
    addMoves(events, facts, indices);
    std::sort(indices.begin(), indices.end());
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
  }
  for (std::size_t k = 0; k < indices.size();) {
    std::size_t last = k;
    while (last + 1 < indices.size() && alike(events[indices[k]], events[indices[last + 1]])) ++last;
    std::string text = told(events, indices[last]);
    if (last > k) text += fmt::format(" The last of {} times since event {}.", last - k + 1, indices[k]);
    answer.say(text);
    k = last + 1;
  }
  if (facts.death) answer.say(ending(events, *facts.death));
  return answer.take();
}

}  // namespace triscope
