#include "core/run/run_record.h"

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
  while (!insertions_.empty() && insertions_.back().first > tick) insertions_.pop_back();
  if (!insertions_.empty()) insertions_.back().last = std::min(insertions_.back().last, tick);
  while (!surplus_.empty() && surplus_.back().tick > tick) surplus_.pop_back();
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
  if (state.mesh.points.size() > beat.pointsBefore) {
    if (!insertions_.empty() && insertions_.back().last + 1 == state.tick)
      insertions_.back().last = state.tick;
    else
      insertions_.push_back({state.tick, state.tick});
  }
  const std::int64_t surplus = static_cast<std::int64_t>(beat.events) - static_cast<std::int64_t>(state.tick);
  if (surplus_.empty() || surplus_.back().events != surplus) surplus_.push_back({state.tick, surplus});
  record_.ticks = state.tick;
}

std::uint64_t RunRecorder::insertionBefore(std::uint64_t tick) const {
  const auto after = std::lower_bound(insertions_.begin(), insertions_.end(), tick,
                                      [](Stretch stretch, std::uint64_t t) { return stretch.first < t; });
  return after == insertions_.begin() ? 0 : std::min((after - 1)->last, tick - 1);
}

std::size_t RunRecorder::bytes() const {
  return insertions_.capacity() * sizeof(insertions_[0]) + surplus_.capacity() * sizeof(surplus_[0]);
}

std::optional<std::uint64_t> RunRecorder::tickOfEvent(std::uint64_t index) const {
  // The first change that comes with a later event: the decision looked for is that one, or one before it.
  const auto after = std::upper_bound(surplus_.begin(), surplus_.end(), index,
                                      [](std::uint64_t event, Surplus s) { return event < s.eventsAfter(s.tick); });
  const std::uint64_t end = after == surplus_.end() ? record_.ticks + 1 : after->tick;
  if (after != surplus_.begin()) {
    const auto tick = static_cast<std::uint64_t>(static_cast<std::int64_t>(index) + 1 - (after - 1)->events);
    if (tick < end) return tick;
  }
  return end <= record_.ticks ? std::optional(end) : std::nullopt;
}

}  // namespace triscope
