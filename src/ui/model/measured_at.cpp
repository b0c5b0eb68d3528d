#include "ui/model/measured_at.h"

#include <fmt/format.h>

#include "core/base/number.h"

namespace triscope {

std::optional<QualitySample> measuredAt(const View& view, std::uint64_t tick) {
  const Snapshot* const now = view.now();
  if (now != nullptr && now->state.tick == tick && !view.session.stale()) return sampleOf(tick, now->quality);
  const QualitySample* const sample = sampleAt(view.session.record(), tick);
  return sample == nullptr ? std::nullopt : std::optional(*sample);
}

std::string sampledBefore(const QualitySample& sample, std::uint64_t tick) {
  return sample.tick == tick ? std::string() : fmt::format(" after decision {}", grouped(sample.tick));
}

}  // namespace triscope
