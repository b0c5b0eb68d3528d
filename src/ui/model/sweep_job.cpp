#include "ui/model/sweep_job.h"

#include <thread>

#include "core/method/pipeline.h"
#include "core/method/triangle_limit.h"

namespace triscope {
namespace {

/// One core is left to the window where there are more than two.
unsigned threadsBesideWindow() {
  const unsigned cores = std::thread::hardware_concurrency();
  return cores > 2 ? cores - 1 : cores;
}

Error cancelled() { return {.kind = ErrorKind::cancelled, .message = "the sweep was cancelled"}; }

}  // namespace

void SweepJob::start(Task task, std::function<void()> wake) {
  cancel_ = false;
  preparing_ = task.from == nullptr || task.from->stage != Stage::refine;
  fresh_.clear();
  std::function<void()> tell = wake;
  job_.start([this, task = std::move(task), tell = std::move(tell)] { return carryOut(task, tell); }, std::move(wake));
}

std::vector<SweepJob::Cell> SweepJob::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(fresh_, {});
}

Status SweepJob::carryOut(const Task& task, const std::function<void()>& wake) {
  if (const Status sensible = canSweep(task.settings); !sensible.ok()) return sensible.error();
  MeshState state;
  if (task.from != nullptr) {
    state = *task.from;
    state.settings = task.settings;
  } else {
    Result<MeshState> begun = begin(task.domain, task.settings, [this](double) { return !cancel_; });
    if (!begun) return begun.error();
    state = std::move(*begun);
  }
  const bool prepared = advanceUntil(state, Stage::step5, cancel_);
  preparing_ = false;
  if (!prepared) return cancelled();
  if (overLimit(state)) return tooManyTriangles(state);
  if (state.failed)
    return Error{.kind = ErrorKind::unmet,
                 .message = "the method cannot go on before step 6, so there is nothing to sweep",
                 .hint = "run to the end to see where it stops, and change the domain or a parameter",
                 .file = task.domain->file};
  sweep(
      state, task.omegas, task.thetas, threadsBesideWindow(),
      [&](std::size_t cell, const SweepRow& row) {
        {
          const std::lock_guard lock(mutex_);
          fresh_.emplace_back(cell, row);
        }
        wake();
      },
      cancel_);
  return cancel_ ? Status(cancelled()) : success();
}

}  // namespace triscope
