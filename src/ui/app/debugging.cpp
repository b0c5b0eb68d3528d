#include "ui/app/debugging.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/counted.h"
#include "core/words/vocabulary.h"

namespace triscope {
namespace {

/// The place of an element in the mesh is found afterwards, by its id.
Pick pickOf(Ref ref) {
  Pick pick;
  pick.id = ref.id;
  pick.selection.index = static_cast<std::int32_t>(ref.id);
  pick.selection.kind = ref.kind == Ref::Kind::triangle ? Selection::Kind::triangle
                        : ref.kind == Ref::Kind::vertex ? Selection::Kind::vertex
                                                        : Selection::Kind::cell;
  return pick;
}

/// Decisions that have a bookmark, or met a breakpoint that did not stop there, in order.
std::vector<std::uint64_t> marksOf(const Desk& desk) {
  std::vector<std::uint64_t> marks;
  marks.reserve(desk.ui.debug.bookmarks.size() + desk.session.hits().size());
  for (const Bookmark& mark : desk.ui.debug.bookmarks) marks.push_back(mark.tick);
  for (const PassedHit& hit : desk.session.hits()) marks.push_back(hit.tick);
  std::ranges::sort(marks);
  return marks;
}

}  // namespace

void Debugging::showFound() {
  if (!searching_ || desk_.session.busy() || desk_.shown == nullptr) return;
  searching_ = false;
  if (!desk_.shown->last || !wordsOf(desk_.shown->last->kind).placed) return;
  const Point place = desk_.shown->last->at;
  if (shows(desk_.ui.camera, {place, place})) return;
  desk_.ui.camera.centre = place;
  desk_.ui.fitted = false;
}

void Debugging::toggleBreakpoint() {
  const Ref ref = *refOf(desk_.ui.selected);
  const std::string text = fmt::format("{} == {}", nameOf(ref.kind), ref.id);
  std::vector<Breakpoint> list = desk_.session.breakpoints();
  const std::size_t taken = std::erase_if(list, [&text](const Breakpoint& b) { return b.condition.text() == text; });
  if (taken == 0) list.push_back({*Condition::compile(text)});
  desk_.session.apply(command::SetBreakpoints{std::move(list)});
  desk_.ui.message = taken == 0 ? fmt::format("Breakpoint: {}. F5 and Shift+F5 go to it.", text)
                                : fmt::format("Breakpoint taken away: {}.", text);
}

void Debugging::toggleBookmark() {
  const std::uint64_t tick = desk_.shown->state.tick;
  std::vector<Bookmark>& marks = desk_.ui.debug.bookmarks;
  const auto at = std::lower_bound(marks.begin(), marks.end(), tick,
                                   [](const Bookmark& mark, std::uint64_t t) { return mark.tick < t; });
  if (at != marks.end() && at->tick == tick) {
    marks.erase(at);
    desk_.ui.message = "The bookmark was taken away.";
    return;
  }
  marks.insert(at, {tick, fmt::format("Decision {}", tick)});
  desk_.ui.message = fmt::format("Bookmark at decision {}. J and Shift+J go to it.", grouped(tick));
}

void Debugging::goToMarkBefore() {
  const std::vector<std::uint64_t> marks = marksOf(desk_);
  const auto here = std::ranges::lower_bound(marks, desk_.shown->state.tick);
  if (here != marks.begin()) desk_.orders.emplace_back(command::Seek{*(here - 1)});
}

void Debugging::goToMarkAfter() {
  const std::vector<std::uint64_t> marks = marksOf(desk_);
  const auto next = std::ranges::upper_bound(marks, desk_.shown->state.tick);
  if (next != marks.end()) desk_.orders.emplace_back(command::Seek{*next});
}

void Debugging::addBreakpoint() {
  DebugUi& debug = desk_.ui.debug;
  Result<Condition> condition = Condition::compile(debug.condition);
  if (!condition) {
    debug.complaint = condition.error();
    return;
  }
  std::vector<Breakpoint> list = desk_.session.breakpoints();
  list.push_back({std::move(*condition), debug.action});
  debug.condition.clear();
  debug.complaint.reset();
  desk_.orders.emplace_back(command::SetBreakpoints{std::move(list)});
}

void Debugging::type(const order::TypeCondition& typed) {
  DebugUi& debug = desk_.ui.debug;
  debug.condition = typed.text;
  debug.action = typed.action;
  debug.complaint.reset();
}

void Debugging::follow(Ref ref) {
  if (ref.kind == Ref::Kind::event) {
    desk_.orders.emplace_back(command::SeekEvent{ref.id});
    return;
  }
  select(desk_.ui, pickOf(ref));
  if (runOf(desk_).selection().kind == Selection::Kind::none)
    desk_.ui.message = fmt::format("{} is not part of the mesh at this moment.", nameOf(ref));
}

void Debugging::keepInRange() {
  DebugUi& debug = desk_.ui.debug;
  if (desk_.shown == nullptr || debug.to <= debug.from) return;
  const double width = debug.to - debug.from;
  const auto tick = static_cast<double>(desk_.shown->state.tick);
  if (tick < debug.from) debug.from = std::max(0.0, tick - 0.1 * width);
  if (tick > debug.from + width) debug.from = tick - 0.9 * width;
  debug.to = debug.from + width;
}

void Debugging::updateAnswers() {
  if (desk_.ui.debug.bottom != Panel::plots)
    desk_.ui.options.brush = {};  // a mark goes with the panel that can take it away
  if (desk_.session.stale()) return;
  const Panel tab = desk_.ui.debug.rightTab;
  if (tab == Panel::why || tab == Panel::history) update(answers_.answers, desk_.session, refOf(desk_.ui.selected));
  if (desk_.ui.debug.bottom == Panel::plots) update(answers_.histogram, desk_.session, desk_.ui.debug.histogram);
}

void Debugging::forget() {
  desk_.ui.debug.from = desk_.ui.debug.to = 0.0;
  searching_ = false;
}

}  // namespace triscope
