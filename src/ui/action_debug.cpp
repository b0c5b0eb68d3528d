// Which actions of the debugger can be done now, and why the others cannot.
#include <algorithm>

#include "ui/pinned_run.h"
#include "ui/view.h"

namespace triscope {
namespace {

bool anyMark(const View& view, bool after) {
  const std::uint64_t tick = view.now()->state.tick;
  const auto beyond = [&](const auto& mark) { return after ? mark.tick > tick : mark.tick < tick; };
  const std::vector<Bookmark>& bookmarks = view.ui.debug.bookmarks;
  const std::vector<PassedHit>& hits = view.session.hits();
  return std::any_of(bookmarks.begin(), bookmarks.end(), beyond) || std::any_of(hits.begin(), hits.end(), beyond);
}

bool anyStop(const std::vector<Breakpoint>& list) {
  return std::any_of(list.begin(), list.end(),
                     [](const Breakpoint& b) { return b.enabled && b.action == Breakpoint::Action::stop; });
}

}  // namespace

std::string whyNotDebug(Action action, const View& view) {
  const bool aboutRun = action >= Action::continue_forward && action <= Action::why;
  if (!aboutRun && action != Action::pin_run && action != Action::first_difference) return {};
  if (view.now() == nullptr) return "There is no mesh yet.";
  if (view.session.stale()) return "A new mesh is being made; wait, or press Esc to keep the old one.";
  const MeshState& state = view.now()->state;
  const bool selected = view.ui.selected.selection.kind != Selection::Kind::none;
  switch (action) {
    case Action::continue_forward:
      if (state.failed) return "The method stopped here; change a parameter or the domain.";
      return state.stage == Stage::finished ? "The run is finished. Go back, or restart." : "";
    case Action::continue_back:
      if (state.tick == 0) return "This is the start of the run.";
      return anyStop(view.session.breakpoints()) ? "" : "There is no breakpoint that stops; add one (Ctrl+B).";
    case Action::breakpoint:
      if (!selected) return "Select a triangle, a vertex or a cell first.";
      return "";
    case Action::previous_mark:
      return anyMark(view, false) ? "" : "There is no mark before this decision.";
    case Action::next_mark:
      return anyMark(view, true) ? "" : "There is no mark after this decision.";
    case Action::first_difference:
      if (view.pinned == nullptr) return "No run is pinned as A (A).";
      if (view.pinned->session().busy()) return "Run A is being made.";
      return view.pinned->firstDifference() ? "" : "Both runs tell the same.";
    case Action::why:
      return selected ? "" : "Select a triangle, a vertex or a cell first.";
    default:
      return {};
  }
}

}  // namespace triscope
