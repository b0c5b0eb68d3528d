#include "ui/app/sweeping.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/base/number.h"
#include "ui/kit/widgets.h"

namespace triscope {
namespace {

/// The furthest that the run at hand has come on the way to step 6; null when a sweep cannot use it.
std::shared_ptr<const MeshState> startOf(const Session& session) {
  const SnapshotPtr& now = session.current();
  const std::shared_ptr<const MeshState> shown(now, now ? &now->state : nullptr);
  for (const std::shared_ptr<const MeshState>& state : {session.beforeRefinement(), shown})
    if (state && state->domain == session.domain() && precedesRefinement(*state, session.settings())) return state;
  return nullptr;
}

/// `settings` with the ω and θ of a cell.
Settings withPairOf(const SweepTable& table, std::size_t cell, Settings settings) {
  settings.omega = table.omegas[cell / table.thetas.size()];
  settings.theta = table.thetas[cell % table.thetas.size()];
  return settings;
}

}  // namespace

bool Sweeping::mapShown() const {
  return desk_.ui.debug.bottom == Panel::sweep && desk_.ui.sweep.shown() && desk_.ui.dialog == Dialog::none;
}

std::optional<Action> Sweeping::mapAction(int key, int mods) const {
  if (!mapShown() || menuOpen()) return std::nullopt;
  const std::optional<Action> action = actionFor(key, mods, Scope::heat_map);
  // Up and Down mean nothing else: they give the map the keys.
  const bool begins = action == Action::cell_up || action == Action::cell_down;
  return desk_.ui.sweep.chosen || begins ? action : std::nullopt;
}

void Sweeping::moveCell(Action direction) {
  const SweepTable& table = *desk_.ui.sweep.shown();
  std::optional<std::size_t>& chosen = desk_.ui.sweep.chosen;
  if (!chosen) {
    chosen = nearestCell(table, desk_.session.settings());
    return;
  }
  const std::size_t rows = table.thetas.size();
  const std::size_t column = *chosen / rows;
  const std::size_t row = *chosen % rows;
  if (direction == Action::cell_left && column > 0) *chosen -= rows;
  if (direction == Action::cell_right && column + 1 < table.omegas.size()) *chosen += rows;
  if (direction == Action::cell_down && row > 0) *chosen -= 1;
  if (direction == Action::cell_up && row + 1 < rows) *chosen += 1;
}

void Sweeping::takeCell() {
  const Settings settings = withPairOf(*desk_.ui.sweep.shown(), *desk_.ui.sweep.chosen, desk_.session.settings());
  // The figures of the cell are those of where step 6 ends.
  const MeshState& shown = desk_.shown->state;
  const Stage after = settings.optimise ? Stage::optimise : Stage::finished;
  if (shown.stage != after || shown.cursor.begun) desk_.orders.emplace_back(command::GoTo{after});
  if (settings != desk_.session.settings()) desk_.orders.emplace_back(command::Change{settings});
}

void Sweeping::run() {
  SweepUi& sweep = desk_.ui.sweep;
  sweep.chosen.reset();
  SweepJob::Task task{desk_.session.domain(), desk_.session.settings(), sweptValues(sweep.choice.omega),
                      sweptValues(sweep.choice.theta), startOf(desk_.session)};
  sweep.making = tableOf(task.domain, task.settings, task.omegas, task.thetas);
  sweep.done = 0;
  desk_.ui.debug.bottom = Panel::sweep;
  since_ = std::chrono::steady_clock::now();
  job_.start(std::move(task), desk_.wake);
  sweep.preparing = job_.preparing();
}

bool Sweeping::follow() {
  SweepUi& sweep = desk_.ui.sweep;
  if (!sweep.making) return false;
  const std::optional<Status> outcome = job_.finished();
  const std::vector<SweepJob::Cell> fresh = job_.take();
  const bool news = outcome || !fresh.empty() || sweep.preparing != job_.preparing();
  sweep.preparing = job_.preparing();
  for (const auto& [cell, row] : fresh) sweep.making->cells[cell] = row;
  sweep.done += fresh.size();
  if (outcome) finish(*outcome);
  return news;
}

void Sweeping::finish(const Status& outcome) {
  SweepUi& sweep = desk_.ui.sweep;
  std::optional<SweepTable> made = std::exchange(sweep.making, std::nullopt);
  if (!outcome.ok()) sweep.chosen.reset();  // the one before is shown again, which may be smaller
  if (outcome.ok()) {
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - since_;
    sweep.seconds = spent.count();
    sweep.table = std::move(made);
    desk_.ui.message = fmt::format("The sweep is done: {} pairs in {} s.", sweep.done, compact(sweep.seconds));
  } else if (outcome.error().kind != ErrorKind::cancelled) {
    complain(desk_.ui, outcome.error());
  } else if (desk_.ui.message.empty()) {
    desk_.ui.message = "The sweep was given up.";
  }
}

}  // namespace triscope
