#include "core/debug/answer.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/caption.h"

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

std::string capitalised(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

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
  const auto triangle = [&](std::uint32_t id) {
    return id == kNoId ? std::nullopt : reasonFor(events, {Ref::Kind::triangle, id}, index);
  };
  switch (e.kind) {
    case EventKind::cell_split:
    case EventKind::cell_ranked:
      if (e.other == kNoId) return std::nullopt;
      if (e.rule == Rule::balance || e.rule == Rule::advancing_front)
        return reasonFor(events, {Ref::Kind::cell, e.other}, index);
      return firstBefore(events, index,
                         [&](const Event& c) { return c.kind == EventKind::constraint_found && c.subject == e.other; });
    case EventKind::vertex_inserted:
    case EventKind::vertex_refused:
      if (e.rule == Rule::initial)
        return firstBefore(events, index,
                           [&](const Event& p) { return p.kind == EventKind::boundary_point && p.at == e.at; });
      if (e.rule == Rule::first_front || e.rule == Rule::second_front)
        return reasonFor(events, {Ref::Kind::vertex, e.other}, index);
      return triangle(e.subject);
    case EventKind::edge_split:
      return triangle(e.other);
    case EventKind::edge_flipped:
    case EventKind::vertex_removed:
    case EventKind::vertex_moved:
    case EventKind::vertex_kept:
      return triangle(e.subject);
    default:
      return std::nullopt;
  }
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
