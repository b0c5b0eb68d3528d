// The worst measures along a run, found by replaying it a little at a time when there is nothing else to do, so that
// making a mesh pays nothing for them.
#pragma once

#include <chrono>
#include <vector>

#include "core/history/history.h"
#include "core/quality/running_quality.h"
#include "core/run_record.h"

namespace triscope {

class QualityTrace {
 public:
  static constexpr std::size_t kMostSamples = 4096;  // beyond it every second one goes

  /// What comes after these decisions will be another run.
  void forgetAfter(std::uint64_t tick);
  /// Replays on, at least a few decisions and for about this long. False when it has come to `end` decisions.
  bool carryOn(const History& history, std::uint64_t end, std::chrono::steady_clock::duration patience);
  /// By tick.
  [[nodiscard]] const std::vector<QualitySample>& samples() const { return samples_; }

 private:
  void sample();

  std::vector<QualitySample> samples_;
  std::uint64_t stride_ = 8;  // decisions between samples
  bool ready_ = false;        // the rest belongs to the run
  MeshState state_;
  RunningQuality quality_;
};

}  // namespace triscope
