#include "core/run/element_events.h"

#include "core/words/vocabulary.h"

namespace triscope {
namespace {

Names namesOf(Ref::Kind kind) {
  switch (kind) {
    case Ref::Kind::triangle:
      return Names::triangle;
    case Ref::Kind::vertex:
      return Names::vertex;
    case Ref::Kind::cell:
      return Names::cell;
    case Ref::Kind::event:
      break;
  }
  return Names::nothing;
}

/// Whether events of a kind make elements of that kind.
bool makes(EventKind event, Ref::Kind kind) {
  const KindWords& words = wordsOf(event);
  return kind == Ref::Kind::vertex ? (words.does & kInserts) != 0 : words.created == namesOf(kind);
}

bool makesElementsOf(const Event& e, Ref::Kind kind) {
  if (kind == Ref::Kind::event) return true;
  return makes(e.kind, kind) && (kind == Ref::Kind::vertex ? e.vertex : e.created) != kNoId;
}

/// False when none of those events makes elements of the kind.
bool mayMakeElementsOf(const Mentioned& events, Ref::Kind kind) {
  if (kind == Ref::Kind::event) return true;
  if (kind == Ref::Kind::triangle) return events.created.low <= events.created.high;
  for (int k = 0; k < kEventKindCount; ++k) {
    const auto event = static_cast<EventKind>(k);
    if (makes(event, kind) && events.has(event)) return true;
  }
  return false;
}

/// Ids that an event made: first, and how many.
struct Range {
  std::uint32_t first;
  std::uint32_t count;
};

Range madeBy(const Event& e, Ref::Kind kind) {
  return kind == Ref::Kind::vertex ? Range{e.vertex, 1} : Range{e.created, e.createdCount};
}

}  // namespace

bool made(const Event& event, Ref ref) {
  if (ref.kind == Ref::Kind::event || !makesElementsOf(event, ref.kind)) return false;
  const Range range = madeBy(event, ref.kind);
  return ref.id >= range.first && ref.id - range.first < range.count;
}

bool isAbout(const Event& event, Ref ref) {
  if (ref.kind == Ref::Kind::event) return false;
  if (made(event, ref)) return true;
  const Names what = namesOf(ref.kind);
  return (wordsOf(event.kind).subject == what && event.subject == ref.id) ||
         (otherOf(event) == what && event.other == ref.id) || (ref.kind == Ref::Kind::vertex && event.vertex == ref.id);
}

bool mayBeAbout(const Mentioned& events, Ref ref) {
  switch (ref.kind) {
    case Ref::Kind::vertex:
      return events.vertex.has(ref.id) || events.other.has(ref.id);
    case Ref::Kind::triangle:
    case Ref::Kind::cell:
      return events.subject.has(ref.id) || events.other.has(ref.id) || events.created.has(ref.id);
    case Ref::Kind::event:
      return false;
  }
  return false;
}

std::optional<std::size_t> birthOf(Events events, Ref ref) {
  if (ref.kind == Ref::Kind::event) return ref.id < events.size() ? std::optional<std::size_t>(ref.id) : std::nullopt;
  // In [low, high): events that make nothing of the kind are stepped over.
  const auto may = [ref](const Mentioned& mentioned) { return mayMakeElementsOf(mentioned, ref.kind); };
  std::size_t low = 0;
  std::size_t high = events.size();
  while (low < high) {
    const std::size_t middle = low + (high - low) / 2;
    std::size_t k = events.next(middle, may);
    while (k < high && !makesElementsOf(events.peek(k), ref.kind)) k = events.next(k + 1, may);
    if (k >= high) {
      high = middle;
      continue;
    }
    const Range range = madeBy(events.peek(k), ref.kind);
    if (ref.id < range.first)
      high = middle;
    else if (ref.id - range.first < range.count)
      return k;
    else
      low = k + 1;
  }
  return std::nullopt;
}

std::vector<std::size_t> eventsAbout(Events events, Ref ref) {
  if (ref.kind == Ref::Kind::event)
    return ref.id < events.size() ? std::vector<std::size_t>{ref.id} : std::vector<std::size_t>{};
  const auto may = [ref](const Mentioned& mentioned) { return mayBeAbout(mentioned, ref); };
  std::vector<std::size_t> found;
  for (std::size_t k = events.next(0, may); k < events.size(); k = events.next(k + 1, may))
    if (isAbout(events.peek(k), ref)) found.push_back(k);
  return found;
}

}  // namespace triscope
