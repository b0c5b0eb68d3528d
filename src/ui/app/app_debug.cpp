// What the debugger's orders and actions do.
#include <fmt/format.h>

#include <algorithm>

#include "core/base/counted.h"
#include "core/words/vocabulary.h"
#include "ui/app/app.h"

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

}  // namespace

void App::search(const Command& command) {
  searching_ = true;
  apply(command);
}

/// Where the search has ended comes into view, as large as the picture is now.
void App::showFound() {
  if (!searching_ || session_.busy() || shown_ == nullptr) return;
  searching_ = false;
  if (!shown_->last || !wordsOf(shown_->last->kind).placed) return;
  const Point place = shown_->last->at;
  if (shows(ui_.camera, {place, place})) return;
  ui_.camera.centre = place;
  fitted_ = false;
}

void App::toggleBreakpoint() {
  const Ref ref = *refOf(ui_.selected);
  const std::string text = fmt::format("{} == {}", nameOf(ref.kind), ref.id);
  std::vector<Breakpoint> list = session_.breakpoints();
  const std::size_t taken = std::erase_if(list, [&text](const Breakpoint& b) { return b.condition.text() == text; });
  if (taken == 0) list.push_back({*Condition::compile(text)});
  apply(command::SetBreakpoints{std::move(list)});
  ui_.message = taken == 0 ? fmt::format("Breakpoint: {}. F5 and Shift+F5 go to it.", text)
                           : fmt::format("Breakpoint taken away: {}.", text);
}

void App::toggleBookmark() {
  const std::uint64_t tick = shown_->state.tick;
  std::vector<Bookmark>& marks = ui_.debug.bookmarks;
  const auto at = std::lower_bound(marks.begin(), marks.end(), tick,
                                   [](const Bookmark& mark, std::uint64_t t) { return mark.tick < t; });
  if (at != marks.end() && at->tick == tick) {
    marks.erase(at);
    ui_.message = "The bookmark was taken away.";
    return;
  }
  marks.insert(at, {tick, fmt::format("Decision {}", tick)});
  ui_.message = fmt::format("Bookmark at decision {}. J and Shift+J go to it.", grouped(tick));
}

void App::goToMark(bool after) {
  const std::uint64_t tick = shown_->state.tick;
  std::optional<std::uint64_t> best;
  const auto offer = [&](std::uint64_t mark) {
    if (after ? mark <= tick : mark >= tick) return;
    if (!best || (after ? mark < *best : mark > *best)) best = mark;
  };
  for (const Bookmark& mark : ui_.debug.bookmarks) offer(mark.tick);
  for (const PassedHit& hit : session_.hits()) offer(hit.tick);
  if (best) apply(command::Seek{*best});
}

void App::addBreakpoint() {
  DebugUi& debug = ui_.debug;
  Result<Condition> condition = Condition::compile(debug.condition);
  if (!condition) {
    debug.complaint = condition.error();
    return;
  }
  std::vector<Breakpoint> list = session_.breakpoints();
  list.push_back({std::move(*condition), debug.action});
  debug.condition.clear();
  debug.complaint.reset();
  apply(command::SetBreakpoints{std::move(list)});
}

void App::follow(Ref ref) {
  if (ref.kind == Ref::Kind::event) return apply(command::SeekEvent{ref.id});
  select(pickOf(ref));
  if (view().selection().kind == Selection::Kind::none)
    ui_.message = fmt::format("{} is not part of the mesh at this moment.", nameOf(ref));
}

void App::keepInRange() {
  DebugUi& debug = ui_.debug;
  if (debug.to <= debug.from) return;
  const double width = debug.to - debug.from;
  const auto tick = static_cast<double>(shown_->state.tick);
  if (tick < debug.from) debug.from = std::max(0.0, tick - 0.1 * width);
  if (tick > debug.from + width) debug.from = tick - 0.9 * width;
  debug.to = debug.from + width;
}

void App::updateAnswers() {
  if (ui_.debug.bottom != Panel::plots) ui_.options.brush = {};  // a mark goes with the panel that can take it away
  if (session_.stale()) return;
  const Panel tab = ui_.debug.rightTab;
  if (tab == Panel::why || tab == Panel::history) update(answers_.answers, session_, refOf(ui_.selected));
  if (ui_.debug.bottom == Panel::plots) update(answers_.histogram, session_, ui_.debug.histogram);
}

void App::drawBottom(const Layout& layout, const View& shown, Orders& orders) {
  if (beginRegion("##timeline", layout.timeline, {shown.px(12), shown.px(5)})) drawTimeline(shown, orders);
  ImGui::End();
  if (layout.bottom.size.y <= 0.0f) return;
  if (beginRegion("##bottom", layout.bottom, {shown.px(12), shown.px(6)})) {
    for (const PanelInfo& panel : panels())
      if (panel.id == ui_.debug.bottom) panel.draw(shown, orders);
  }
  ImGui::End();
}

}  // namespace triscope
