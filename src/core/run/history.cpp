#include "core/run/history.h"

#include <algorithm>
#include <utility>

#include "core/base/assert.h"

namespace triscope {
namespace {

constexpr std::uint64_t kFirstSpacing = 1024;

template <class T>
std::size_t bytesIn(const std::vector<T>& list) {
  return list.size() * sizeof(T);
}

}  // namespace

std::size_t bytesOf(const MeshState& s) {
  const Mesh& m = s.mesh;
  return sizeof(MeshState) + bytesIn(m.points) + bytesIn(m.kinds) + bytesIn(m.density) + bytesIn(m.vertexTriangle) +
         bytesIn(m.vertexEdge) + bytesIn(m.triangles) + bytesIn(m.ids) + bytesIn(m.flags) + bytesIn(m.tested) +
         bytesIn(m.freeSlots) + bytesIn(m.edges) + bytesIn(s.constraints) + bytesIn(s.search.found) +
         bytesIn(s.tree.cells) + bytesIn(s.boundary) + bytesIn(s.front1) + bytesIn(s.front2) + bytesIn(s.frontLoops) +
         bytesIn(s.cursor.worklist) + bytesIn(s.cursor.next) + bytesIn(s.cursor.points);
}

bool hasComeTo(const MeshState& state, Stage stage) {
  if (inRounds(stage) && inRounds(state.stage) && state.round > 1) return true;
  return state.stage > stage || (state.stage == stage && state.cursor.begun);
}

void History::restart(const MeshState& start) {
  keyframes_.clear();
  keyframes_.push_back(std::make_shared<const Keyframe>(Keyframe{start, 0, bytesOf(start)}));
  settings_ = start.settings;
  bytes_ = keyframes_.front()->bytes;
  spacing_ = kFirstSpacing;
  nextTick_ = start.tick + spacing_;
}

void History::take(const MeshState& state, std::uint64_t events) {
  TRISCOPE_CHECK(!keyframes_.empty(), "the keyframe of the start is kept whatever the budget");
  const std::size_t size = bytesOf(state);
  while (bytes_ + size > budget_ && keyframes_.size() > 1) thin();
  nextTick_ = keyframes_.back()->state.tick + spacing_;
  if (bytes_ + size > budget_ || state.tick < nextTick_) {
    nextTick_ = std::max(nextTick_, state.tick + spacing_);
    return;
  }
  keyframes_.push_back(std::make_shared<const Keyframe>(Keyframe{state, events, size}));
  bytes_ += size;
  nextTick_ = state.tick + spacing_;
}

void History::thin() {
  std::size_t kept = 1;
  for (std::size_t k = 2; k < keyframes_.size(); k += 2) keyframes_[kept++] = std::move(keyframes_[k]);
  keyframes_.resize(kept);
  bytes_ = 0;
  for (const auto& keyframe : keyframes_) bytes_ += keyframe->bytes;
  spacing_ *= 2;
}

void History::dropLast() {
  bytes_ -= keyframes_.back()->bytes;
  keyframes_.pop_back();
}

void History::forgetAfter(std::uint64_t tick) {
  while (keyframes_.size() > 1 && keyframes_.back()->state.tick > tick) dropLast();
  nextTick_ = keyframes_.back()->state.tick + spacing_;
}

const Keyframe& History::before(std::uint64_t tick) const {
  TRISCOPE_CHECK(!keyframes_.empty(), "a history is begun before it is read");
  const auto after = std::upper_bound(keyframes_.begin(), keyframes_.end(), tick,
                                      [](std::uint64_t t, const auto& k) { return t < k->state.tick; });
  return after == keyframes_.begin() ? **after : **(after - 1);
}

MeshState History::stateBefore(std::uint64_t tick) const {
  MeshState state = before(tick).state;
  state.settings = settings_;
  return state;
}

MeshState History::seek(std::uint64_t tick, Journal& journal) const {
  MeshState state = stateBefore(tick);
  while (state.tick < tick && advance(state, Grain::decision, journal)) {
  }
  return state;
}

std::uint64_t History::changeSettings(const Settings& settings) {
  const Stage affected = firstAffected(settings_, settings);
  while (keyframes_.size() > 1 && hasComeTo(keyframes_.back()->state, affected)) dropLast();
  settings_ = settings;
  nextTick_ = keyframes_.back()->state.tick + spacing_;
  return keyframes_.back()->state.tick;
}

}  // namespace triscope
