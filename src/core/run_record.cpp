#include "core/run_record.h"

#include <algorithm>

namespace triscope {

QualitySample sampleOf(std::uint64_t tick, const Quality& q) {
  QualitySample sample{tick, static_cast<std::uint32_t>(q.triangles), static_cast<std::uint32_t>(q.obtuse), {}};
  const auto set = [&sample](Measure measure, double value) {
    sample.worst[static_cast<std::size_t>(measure)] = static_cast<float>(value);
  };
  set(Measure::aspect, q.aspectMax);
  set(Measure::area_ratio, q.areaRatioMax);
  set(Measure::edge_ratio, q.edgeRatioMax);
  set(Measure::min_angle, q.minAngle);
  set(Measure::max_angle, q.maxAngle);
  return sample;
}

const StageEntry* entryAt(const RunRecord& record, std::uint64_t tick) {
  const auto after = std::upper_bound(record.stages.begin(), record.stages.end(), tick,
                                      [](std::uint64_t t, const StageEntry& e) { return t < e.tick; });
  return after == record.stages.begin() ? nullptr : &*(after - 1);
}

const StageEntry* entryOfDecision(const RunRecord& record, std::uint64_t tick) {
  return entryAt(record, tick == 0 ? 0 : tick - 1);
}

const StageEntry* firstEntry(const RunRecord& record, Stage stage) {
  const auto entry = std::find_if(record.stages.begin(), record.stages.end(),
                                  [stage](const StageEntry& e) { return e.stage >= stage; });
  return entry == record.stages.end() ? nullptr : &*entry;
}

const QualitySample* sampleAt(const RunRecord& record, std::uint64_t tick) {
  const auto after = std::upper_bound(record.samples.begin(), record.samples.end(), tick,
                                      [](std::uint64_t t, const QualitySample& s) { return t < s.tick; });
  return after == record.samples.begin() ? nullptr : &*(after - 1);
}

void RunRecorder::forgetAfter(std::uint64_t tick, std::uint64_t events) {
  std::erase_if(record_.stages, [events](const StageEntry& e) { return e.event >= events; });
  while (!insertions_.empty() && insertions_.back() > tick) insertions_.pop_back();
  if (eventsAfter_.size() > tick) eventsAfter_.resize(static_cast<std::size_t>(tick));
  record_.ticks = std::min(record_.ticks, tick);
  record_.complete = false;
  events_ = std::min(events_, events);
}

void RunRecorder::follow(const MeshState& state, const Beat& beat) {
  if (state.stage == Stage::finished || state.failed) record_.complete = true;
  const std::uint64_t first = beat.events - beat.made.size();
  for (std::size_t k = 0; k < beat.made.size(); ++k) {
    const Event& event = beat.made[k];
    if (event.kind == EventKind::stage_begun && first + k >= events_)
      record_.stages.push_back({event.stage, event.round, beat.tickBefore, first + k});
  }
  events_ = std::max(events_, beat.events);
  if (state.tick <= record_.ticks) return;
  if (state.mesh.points.size() > beat.pointsBefore) insertions_.push_back(static_cast<std::uint32_t>(state.tick));
  eventsAfter_.push_back(static_cast<std::uint32_t>(beat.events));
  record_.ticks = state.tick;
}

std::uint64_t RunRecorder::insertionBefore(std::uint64_t tick) const {
  const auto at = std::lower_bound(insertions_.begin(), insertions_.end(), tick);
  return at == insertions_.begin() ? 0 : *(at - 1);
}

std::optional<std::uint64_t> RunRecorder::tickOfEvent(std::uint64_t index) const {
  const auto at = std::upper_bound(eventsAfter_.begin(), eventsAfter_.end(), index);
  if (at == eventsAfter_.end()) return std::nullopt;
  return static_cast<std::uint64_t>(at - eventsAfter_.begin()) + 1;
}

}  // namespace triscope
