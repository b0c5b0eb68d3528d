#include "core/run/quality_trace.h"

#include <algorithm>

#include "core/mesh/change_log.h"
#include "core/method/pipeline.h"

namespace triscope {

void QualityTrace::forgetAfter(std::uint64_t tick) {
  std::erase_if(samples_, [tick](const QualitySample& s) { return s.tick > tick; });
  if (samples_.empty()) stride_ = 8;
  replay_.reset();
}

QualityTrace QualityTrace::upTo(std::uint64_t tick) const {
  QualityTrace trace;
  trace.samples_ = samples_;
  trace.stride_ = stride_;
  trace.forgetAfter(tick);
  return trace;
}

bool QualityTrace::carryOn(const History& history, const RunRecord& run, const std::function<bool()>& enough) {
  const std::uint64_t end = run.ticks;
  const std::uint64_t last = samples_.empty() ? 0 : samples_.back().tick;
  if (last >= end) return false;
  // Samples that would go again are not made: between two of them a triangle is measured once, however often it
  // changed.
  while (samples_.empty() && end / stride_ + 1 >= kMostSamples) stride_ *= 2;
  if (!replay_) {
    replay_.emplace(Replay{history.stateBefore(last), {}});
    replay_->quality.reset(replay_->state.mesh);
  }
  follow(*replay_, end, enough);
  const bool more = replay_->state.tick < end;
  if (!more && run.complete) replay_.reset();  // it is as large as the run, and nothing more will be asked
  return more;
}

void QualityTrace::follow(Replay& replay, std::uint64_t end, const std::function<bool()>& enough) {
  constexpr std::uint64_t kBetweenLooks = 64;
  MeshState& state = replay.state;
  ChangeLog changes(state.mesh);
  Journal deaf;
  while (state.tick < end) {
    const std::uint64_t next = std::min(end, samples_.empty() ? stride_ : samples_.back().tick + stride_);
    if (state.tick >= next || !advanceAPiece(state, deaf)) break;
    if (state.tick >= next) {
      replay.quality.update(state.mesh, changes.slots());
      changes.clear();
      sample(replay);
    }
    if (state.tick % kBetweenLooks == 0 && enough()) break;
  }
  replay.quality.update(state.mesh, changes.slots());
}

void QualityTrace::sample(const Replay& replay) {
  const RunningQuality& quality = replay.quality;
  QualitySample sample{replay.state.tick,
                       static_cast<std::uint32_t>(quality.triangles()),
                       static_cast<std::uint32_t>(quality.obtuse()),
                       {}};
  for (int m = 0; m < kMeasureCount; ++m)
    sample.worst[static_cast<std::size_t>(m)] = static_cast<float>(quality.worst(static_cast<Measure>(m)));
  samples_.push_back(sample);
  if (samples_.size() < kMostSamples) return;
  std::size_t kept = 0;
  for (std::size_t k = 1; k < samples_.size(); k += 2) samples_[kept++] = samples_[k];
  samples_.resize(kept);
  stride_ *= 2;
}

}  // namespace triscope
