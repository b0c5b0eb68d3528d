// Sweeps over ω and θ: starting them, and taking over what comes of them.
#include <fmt/format.h>

#include <utility>

#include "core/number.h"
#include "ui/app.h"
#include "ui/panels.h"

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

}  // namespace

std::vector<double> sweptValues(SweepRange range) {
  if (range.from == range.to) range.count = 1;
  return valuesOf(range);
}

void App::runSweep() {
  SweepUi& sweep = ui_.sweep;
  SweepJob::Task task{session_.domain(), session_.settings(), sweptValues(sweep.choice.omega),
                      sweptValues(sweep.choice.theta), startOf(session_)};
  sweep.making = tableOf(task.domain, task.settings, task.omegas, task.thetas);
  sweep.done = 0;
  ui_.debug.bottom = "Sweep";
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
  if (outcome.ok()) {
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - sweepSince_;
    sweep.seconds = spent.count();
    sweep.table = std::move(made);
    ui_.message = fmt::format("The sweep is done: {} pairs in {} s.", sweep.done, compact(sweep.seconds));
  } else if (outcome.error().code != ExitCode::cancelled) {
    complain(outcome.error());
  } else if (ui_.message.empty()) {
    ui_.message = "The sweep was given up.";
  }
}

}  // namespace triscope
