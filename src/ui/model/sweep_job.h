// A sweep over ω and θ, away from the window's thread.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "core/study/parameter_sweep.h"
#include "ui/model/background_job.h"

namespace triscope {

class SweepJob {
 public:
  struct Task {
    std::shared_ptr<const Domain> domain;
    Settings settings;
    std::vector<double> omegas;
    std::vector<double> thetas;
    std::shared_ptr<const MeshState> from;  // precedesRefinement(); null: the run is begun from nothing
  };
  using Cell = std::pair<std::size_t, SweepRow>;  // its number in a SweepTable

  SweepJob() = default;
  ~SweepJob() { cancel(); }
  SweepJob(const SweepJob&) = delete;
  SweepJob& operator=(const SweepJob&) = delete;

  /// Must not be called while running(). `wake` is called from other threads when there is something to take.
  void start(Task task, std::function<void()> wake);
  /// It is over soon after, and finished() then tells of an error with the code `cancelled`.
  void cancel() { cancel_ = true; }
  [[nodiscard]] bool running() const { return job_.running(); }
  [[nodiscard]] bool preparing() const { return preparing_; }
  /// Cells run since the last call.
  std::vector<Cell> take();
  /// The outcome, once, when there is one; every cell can then be taken.
  std::optional<Status> finished() { return job_.finished(); }

 private:
  Status carryOut(const Task& task, const std::function<void()>& wake);

  std::atomic<bool> cancel_{false};
  std::atomic<bool> preparing_{false};
  std::mutex mutex_;
  std::vector<Cell> fresh_;  // under the mutex
  BackgroundJob job_;        // last: its thread uses what is above
};

}  // namespace triscope
