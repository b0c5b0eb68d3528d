#include "core/explain/answer.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/explain/caption.h"
#include "core/words/vocabulary.h"

namespace triscope {
namespace {

/// True once a stage up to the triangulation has begun. These run once, in order.
bool hasBegun(Events events, Stage stage) {
  for (std::size_t k = events.size(); k-- > 0;)
    if (events.peek(k).stage >= stage) return true;
  return false;
}

template <class Test>
std::optional<std::size_t> firstBefore(Events events, std::size_t end, Test test) {
  for (std::size_t k = 0; k < end; ++k)
    if (test(events.peek(k))) return k;
  return std::nullopt;
}

}  // namespace

std::string told(Events events, std::size_t index) {
  return fmt::format("Event {}: {}", index, captionOf(events[index]));
}

std::string withoutBirth(Events events, Ref ref) {
  const bool box = hasBegun(events, Stage::triangulation);
  if (ref.kind == Ref::Kind::triangle && ref.id < 2 && box)
    return fmt::format("No decision made {}: it is half of the box around everything.", nameOf(ref));
  if (ref.kind == Ref::Kind::vertex && ref.id < 4 && box)
    return fmt::format("No decision made {}: it is a corner of the box around everything.", nameOf(ref));
  if (ref.kind == Ref::Kind::cell && ref.id == 0 && hasBegun(events, Stage::constraints))
    return "No decision made cell 0: it is the root, the square that holds the domain.";
  return fmt::format("There is no {} up to here.", nameOf(ref));
}

std::string ending(Events events, std::size_t death) {
  return fmt::format("It ended with event {}: {}", death, captionOf(events[death]));
}

std::optional<std::size_t> reasonFor(Events events, Ref ref, std::size_t end) {
  if (ref.kind == Ref::Kind::cell) {
    for (std::size_t k = end; k-- > 0;) {
      const Event& e = events.peek(k);
      if (e.kind == EventKind::cell_ranked && e.subject == ref.id) return k;
    }
  }
  return birthOf(events.first(end), ref);
}

std::optional<std::size_t> causeOf(Events events, std::size_t index) {
  const Event e = events[index];
  if (e.rule == Rule::initial)
    return firstBefore(events, index,
                       [&](const Event& p) { return p.kind == EventKind::boundary_point && p.at == e.at; });
  const Named origin = originOf(e);
  if (const auto element = wordsOf(origin.what).element) return reasonFor(events, {*element, origin.id}, index);
  if (origin.what != Names::constraint) return std::nullopt;
  return firstBefore(events, index,
                     [&](const Event& c) { return c.kind == EventKind::constraint_found && c.subject == origin.id; });
}

void Answer::say(const std::string& text) {
  if (!text.empty()) lines_.push_back(linked(text));
}

void Answer::tell(std::size_t index, std::size_t causes) {
  for (std::optional<std::size_t> k = index; k && causes > 0; k = causeOf(events_, *k), --causes) {
    if (std::find(told_.begin(), told_.end(), *k) != told_.end()) return;
    told_.push_back(*k);
    say(told(events_, *k));
  }
}

}  // namespace triscope
