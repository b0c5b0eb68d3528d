#include "core/quality_trace.h"

#include <algorithm>

#include "core/mesh/change_log.h"
#include "core/pipeline.h"

namespace triscope {

void QualityTrace::forgetAfter(std::uint64_t tick) {
  std::erase_if(samples_, [tick](const QualitySample& s) { return s.tick > tick; });
  if (samples_.empty()) stride_ = 8;
  ready_ = false;
}

bool QualityTrace::carryOn(const History& history, std::uint64_t end, std::chrono::steady_clock::duration patience) {
  constexpr std::uint64_t kBetweenLooks = 64;
  const std::uint64_t last = samples_.empty() ? 0 : samples_.back().tick;
  if (last >= end) return false;
  if (!ready_) {
    state_ = history.before(last).state;
    quality_.reset(state_.mesh);
    ready_ = true;
  }
  const auto start = std::chrono::steady_clock::now();
  ChangeLog changes;
  Journal deaf;
  while (state_.tick < end) {
    const std::uint64_t next = std::min(end, samples_.empty() ? stride_ : samples_.back().tick + stride_);
    if (state_.tick >= next || !advanceAPiece(state_, deaf)) break;
    if (state_.tick >= next) {
      quality_.update(state_.mesh, changes.slots);
      changes.slots.clear();
      sample();
    }
    if (state_.tick % kBetweenLooks == 0 && std::chrono::steady_clock::now() - start > patience) break;
  }
  quality_.update(state_.mesh, changes.slots);
  return state_.tick < end;
}

void QualityTrace::sample() {
  QualitySample sample{
      state_.tick, static_cast<std::uint32_t>(quality_.triangles()), static_cast<std::uint32_t>(quality_.obtuse()), {}};
  for (int m = 0; m < kMeasureCount; ++m)
    sample.worst[static_cast<std::size_t>(m)] = static_cast<float>(quality_.worst(static_cast<Measure>(m)));
  samples_.push_back(sample);
  if (samples_.size() < kMostSamples) return;
  std::size_t kept = 0;
  for (std::size_t k = 1; k < samples_.size(); k += 2) samples_[kept++] = samples_[k];
  samples_.resize(kept);
  stride_ *= 2;
}

}  // namespace triscope
