// Sweeps over ω and θ: starting them, and taking over what comes of them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/number.h"
#include "ui/app/app.h"
#include "ui/kit/widgets.h"
#include "ui/region/regions.h"

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

std::vector<double> sweptValues(SweepRange range) {
  if (range.from == range.to) range.count = 1;
  return valuesOf(range);
}

std::size_t nearestCell(const SweepTable& table, const Settings& settings) {
  const auto nearest = [](const std::vector<double>& values, double to) {
    const auto closer = [to](double a, double b) { return std::fabs(a - to) < std::fabs(b - to); };
    return static_cast<std::size_t>(std::min_element(values.begin(), values.end(), closer) - values.begin());
  };
  return nearest(table.omegas, settings.omega) * table.thetas.size() + nearest(table.thetas, settings.theta);
}

bool App::heatMapShown() const {
  return ui_.debug.bottom == Panel::sweep && ui_.sweep.shown() && ui_.dialog == Dialog::none;
}

std::optional<Action> App::heatMapAction(int key, int mods) const {
  if (!heatMapShown() || menuOpen()) return std::nullopt;
  const std::optional<Action> action = actionFor(key, mods, Scope::heat_map);
  // Up and Down mean nothing else: they give the map the keys.
  const bool begins = action == Action::cell_up || action == Action::cell_down;
  return ui_.sweep.chosen || begins ? action : std::nullopt;
}

void App::moveCell(Action action) {
  const SweepTable& table = *ui_.sweep.shown();
  std::optional<std::size_t>& chosen = ui_.sweep.chosen;
  if (!chosen) {
    chosen = nearestCell(table, session_.settings());
    return;
  }
  const std::size_t rows = table.thetas.size();
  const std::size_t column = *chosen / rows;
  const std::size_t row = *chosen % rows;
  if (action == Action::cell_left && column > 0) *chosen -= rows;
  if (action == Action::cell_right && column + 1 < table.omegas.size()) *chosen += rows;
  if (action == Action::cell_down && row > 0) *chosen -= 1;
  if (action == Action::cell_up && row + 1 < rows) *chosen += 1;
}

void App::takeCell() {
  const Settings settings = withPairOf(*ui_.sweep.shown(), *ui_.sweep.chosen, session_.settings());
  // The figures of the cell are those of the end.
  if (shown_->state.stage != Stage::finished) apply(command::Advance{Grain::all});
  if (settings != session_.settings()) apply(command::Change{settings});
}

void App::runSweep() {
  SweepUi& sweep = ui_.sweep;
  sweep.chosen.reset();
  SweepJob::Task task{session_.domain(), session_.settings(), sweptValues(sweep.choice.omega),
                      sweptValues(sweep.choice.theta), startOf(session_)};
  sweep.making = tableOf(task.domain, task.settings, task.omegas, task.thetas);
  sweep.done = 0;
  ui_.debug.bottom = Panel::sweep;
  sweepSince_ = std::chrono::steady_clock::now();
  sweep_.start(std::move(task), wake_);
  sweep.preparing = sweep_.preparing();
}

bool App::followSweep() {
  SweepUi& sweep = ui_.sweep;
  if (!sweep.making) return false;
  const std::optional<Status> outcome = sweep_.finished();
  const std::vector<SweepJob::Cell> fresh = sweep_.take();
  const bool news = outcome || !fresh.empty() || sweep.preparing != sweep_.preparing();
  sweep.preparing = sweep_.preparing();
  for (const auto& [cell, row] : fresh) sweep.making->cells[cell] = row;
  sweep.done += fresh.size();
  if (outcome) finishSweep(*outcome);
  return news;
}

void App::finishSweep(const Status& outcome) {
  SweepUi& sweep = ui_.sweep;
  std::optional<SweepTable> made = std::exchange(sweep.making, std::nullopt);
  if (!outcome.ok()) sweep.chosen.reset();  // the one before is shown again, which may be smaller
  if (outcome.ok()) {
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - sweepSince_;
    sweep.seconds = spent.count();
    sweep.table = std::move(made);
    ui_.message = fmt::format("The sweep is done: {} pairs in {} s.", sweep.done, compact(sweep.seconds));
  } else if (outcome.error().kind != ErrorKind::cancelled) {
    complain(outcome.error());
  } else if (ui_.message.empty()) {
    ui_.message = "The sweep was given up.";
  }
}

}  // namespace triscope
