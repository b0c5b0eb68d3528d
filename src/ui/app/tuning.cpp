#include "ui/app/tuning.h"

#include <utility>

namespace triscope {

void Tuning::change(const Edit& edit) {
  end();
  remember(inForce(desk_));
  bring(edit);
}

void Tuning::hold(const Edit& edit) {
  if (desk_.ui.document.opening) return bring(edit);
  if (!held_) held_ = Held{inForce(desk_)};
  if (!held_->cancelled) bring(edit);
}

void Tuning::end() {
  const std::optional<Held> held = std::exchange(held_, std::nullopt);
  if (held && inForce(desk_) != held->before) remember(held->before);
}

void Tuning::cancel() {
  held_->cancelled = true;
  const Edit before = held_->before;
  const SnapshotPtr& shown = desk_.shown;
  if (desk_.session.stale() && shown != nullptr && Edit{shown->state.settings, shown->state.domain} == before) {
    desk_.orders.emplace_back(command::Cancel{});
    return;
  }
  if (inForce(desk_) != before) bring(before);
}

void Tuning::undo() {
  end();
  const Edit back = desk_.ui.undo.back();
  desk_.ui.redo.push_back(inForce(desk_));
  desk_.ui.undo.pop_back();
  bring(back);
}

void Tuning::redo() {
  if (held_) return end();  // what is being changed comes after what was taken back
  const Edit again = desk_.ui.redo.back();
  desk_.ui.undo.push_back(inForce(desk_));
  desk_.ui.redo.pop_back();
  bring(again);
}

void Tuning::follow() {
  if (desk_.session.busy() || held_) return;
  std::vector<Edit>& undo = desk_.ui.undo;
  while (!undo.empty() && undo.back() == inForce(desk_)) undo.pop_back();
}

void Tuning::forget() {
  held_.reset();
  desk_.ui.undo.clear();
  desk_.ui.redo.clear();
}

void Tuning::remember(const Edit& before) {
  if (desk_.ui.document.opening) return;  // it is of another document than what can be taken back
  desk_.ui.undo.push_back(before);
  desk_.ui.redo.clear();
}

void Tuning::bring(const Edit& edit) {
  walk_.leave();
  walk_.giveUpEntering();
  if (edit.domain == desk_.session.domain()) return give(desk_, command::Change{edit.settings});
  document_.addVersion(edit.domain);
  const MeshState& now = desk_.shown->state;
  const bool toEnd = now.stage == Stage::finished;
  give(desk_,
       command::Load{edit.domain, edit.settings, toEnd ? std::optional<std::uint64_t>() : std::optional(now.tick)});
}

}  // namespace triscope
