#include "core/debug/recording.h"

#include <algorithm>
#include <utility>

#include "core/debug/life.h"

namespace triscope {
namespace {

constexpr std::uint64_t kBeatsPerPulse = 1024;  // a few milliseconds

}  // namespace

Recording::Recording(MeshState start, std::size_t budget) : state_(std::move(start)), history_(budget) {
  history_.restart(state_);
}

void Recording::keepBeat() {
  events_.append(beat_);
  beat_.clear();
}

bool Recording::pulse(const MeshState& state) { return ++beats_ % kBeatsPerPulse != 0 || !pulse_ || pulse_(state); }

template <class Reached>
bool Recording::carryOn(Reached reached) {
  Journal journal{&beat_};
  bool decided = true;  // not in the middle of a decision
  while (!decided || !reached()) {
    const std::uint64_t tick = state_.tick;
    if (!pulse(state_)) return false;
    const bool more = advanceAPiece(state_, journal);
    keepBeat();
    if (!more) return false;
    decided = state_.tick > tick || over();
    if (state_.tick > tick) history_.offer(state_, events_.size());
  }
  return true;
}

void Recording::returnTo(std::uint64_t tick) {
  const Keyframe& keyframe = history_.before(tick);
  events_.truncate(static_cast<std::size_t>(keyframe.events));
  Journal journal{&beat_};
  state_ = history_.seek(tick, journal);
  keepBeat();
}

bool Recording::toEnd() {
  carryOn([&] { return over(); });
  return over();
}

bool Recording::toTick(std::uint64_t tick) {
  if (tick < state_.tick) returnTo(tick);
  return carryOn([&] { return state_.tick >= tick; });
}

bool Recording::toEvent(std::size_t index) {
  if (index < events_.size()) {
    returnTo(tickOf(history_, state_.tick, index));
  }
  return carryOn([&] { return events_.size() > index; });
}

bool Recording::toStage(Stage stage) {
  if (hasComeTo(state_, stage)) returnTo(0);
  Journal journal{&beat_};
  while (state_.stage != stage) {
    const std::uint64_t tick = state_.tick;
    if (over() || !pulse(state_)) return false;
    advanceUntil(state_, Stage::refine, 1, journal);
    keepBeat();
    if (state_.tick > tick) history_.offer(state_, events_.size());
  }
  return true;
}

std::optional<Hit> Recording::toNextHit(std::span<const Breakpoint> breakpoints, std::vector<Hit>& passed) {
  Watch watch(state_, breakpoints);
  std::vector<Hit> hits;
  while (pulse(state_) && watch.step(hits)) {
    events_.append(watch.events());
    if (!over() && !watch.events().empty()) history_.offer(state_, events_.size());
    std::optional<Hit> stop;
    for (const Hit& hit : hits) {
      if (breakpoints[hit.breakpoint].action != Breakpoint::Action::stop)
        passed.push_back(hit);
      else if (!stop)
        stop = hit;
    }
    if (stop) return stop;
    hits.clear();
  }
  return std::nullopt;
}

std::optional<Hit> Recording::toPreviousHit(std::span<const Breakpoint> breakpoints) {
  const std::optional<Hit> hit =
      continueBackward(history_, state_.tick, breakpoints, [this](const MeshState& state) { return pulse(state); });
  if (hit) returnTo(hit->tick);
  return hit;
}

std::size_t Recording::eventOf(const Hit& hit) const {
  const auto same = [&](const Event& e) {
    return e.kind == hit.event.kind && e.stage == hit.event.stage && e.rule == hit.event.rule &&
           e.subject == hit.event.subject && e.other == hit.event.other && e.vertex == hit.event.vertex &&
           e.round == hit.event.round && e.at == hit.event.at;
  };
  std::size_t k = events_.size();
  while (k > 0 && !same(events_.peek(k - 1))) --k;
  return k - 1;
}

}  // namespace triscope
