// Sweeps over ω and θ: starting them, taking over what comes of them, and going about in their heat map.
#pragma once

#include <chrono>

#include "ui/app/desk.h"
#include "ui/model/sweep_job.h"

namespace triscope {

class Sweeping {
 public:
  explicit Sweeping(Desk& desk) : desk_(desk) {}

  void run();
  /// It is over soon after; the sweep before is shown again.
  void cancel() { job_.cancel(); }
  /// Takes over the pairs that have been run. True when there is something new to show.
  bool follow();
  /// Chooses the next cell of the map in a direction; at first that of the run shown.
  void moveCell(Action direction);
  /// Meshes with the pair of the cell that is chosen.
  void takeCell();
  /// Whether the heat map is to be seen, so that keys may be meant for it.
  [[nodiscard]] bool mapShown() const;
  /// What a key means to the map; nothing where it is not the map's.
  [[nodiscard]] std::optional<Action> mapAction(int key, int mods) const;

 private:
  void finish(const Status& outcome);

  Desk& desk_;
  std::chrono::steady_clock::time_point since_;
  SweepJob job_;
};

}  // namespace triscope
