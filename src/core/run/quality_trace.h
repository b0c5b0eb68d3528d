// The worst measures along a run, found by replaying it a little at a time when there is nothing else to do, so that
// making a mesh pays nothing for them.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/quality/running_quality.h"
#include "core/run/history.h"
#include "core/run/run_record.h"

namespace triscope {

class QualityTrace {
 public:
  static constexpr std::size_t kMostSamples = 4096;  // beyond it every second one goes

  /// What comes after these decisions will be another run.
  void forgetAfter(std::uint64_t tick);
  /// One of its own that has the samples up to there.
  [[nodiscard]] QualityTrace upTo(std::uint64_t tick) const;
  /// Replays on, at least a few decisions and until `enough` says so, which is asked every few. False when it has come
  /// to the end of what is known of the run.
  bool carryOn(const History& history, const RunRecord& run, const std::function<bool()>& enough);
  /// By tick.
  [[nodiscard]] const std::vector<QualitySample>& samples() const { return samples_; }

 private:
  struct Replay {
    MeshState state;
    RunningQuality quality;
  };
  /// Replays up to `end`, or until `enough`, and leaves what it measures up to date.
  void follow(Replay& replay, std::uint64_t end, const std::function<bool()>& enough);
  void sample(const Replay& replay);

  std::vector<QualitySample> samples_;
  std::uint64_t stride_ = 8;      // decisions between samples
  std::optional<Replay> replay_;  // where the samples end
};

}  // namespace triscope
