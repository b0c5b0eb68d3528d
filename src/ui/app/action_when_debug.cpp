// When what the debugger and comparisons offer can be done.
#include <algorithm>

#include "ui/app/action_when.h"
#include "ui/model/pinned_run.h"

namespace triscope::when {
namespace {

bool anyMark(const RunView& view, bool after) {
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

std::string holdsRun(const RunView& view) {
  if (view.now() == nullptr) return "There is no mesh yet.";
  return view.session.stale() ? "A new mesh is being made; wait, or press Esc to keep the old one." : "";
}

std::string continuesBack(const RunView& view) {
  if (std::string reason = goesBack(view); !reason.empty()) return reason;
  return anyStop(view.session.breakpoints()) ? "" : "There is no breakpoint that stops; add one (Ctrl+B).";
}

std::string hasSelection(const RunView& view) {
  if (std::string reason = holdsRun(view); !reason.empty()) return reason;
  const bool selected = view.ui.selected.selection.kind != Selection::Kind::none;
  return selected ? "" : "Select a triangle, a vertex or a cell first.";
}

std::string hasMarkBefore(const RunView& view) {
  if (std::string reason = holdsRun(view); !reason.empty()) return reason;
  return anyMark(view, false) ? "" : "There is no mark before this decision.";
}

std::string hasMarkAfter(const RunView& view) {
  if (std::string reason = holdsRun(view); !reason.empty()) return reason;
  return anyMark(view, true) ? "" : "There is no mark after this decision.";
}

std::string differs(const RunView& view) {
  if (std::string reason = holdsRun(view); !reason.empty()) return reason;
  if (view.pinned == nullptr) return "No run is pinned as A (A).";
  if (view.pinned->session().busy()) return "Run A is being made.";
  return view.pinned->firstDifference() ? "" : "Both runs tell the same.";
}

}  // namespace triscope::when
