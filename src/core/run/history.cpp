#include "core/run/history.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

#include "core/base/assert.h"

namespace triscope {
namespace {

constexpr std::uint64_t kFirstSpacing = 1024;
// A state of more than some bytes is copied into memory that the system has to clear first. So many of them take a
// tenth of the time of a decision: that is what keyframes may cost a run.
constexpr std::size_t kLargeState = std::size_t{1} << 19;
constexpr std::size_t kBytesPerDecision = 64;
constexpr std::uint64_t kNear = 8192;  // work that is done again in about the time that it takes to copy a large state
constexpr std::uint64_t kLeastWay = 128;  // decisions: a shorter way is gone again at once
constexpr std::uint64_t kNearest = 16;    // the next place to look at is so many times nearer: decisions may take long
constexpr std::uint64_t kNowhere = ~std::uint64_t{0};

template <class T>
std::size_t bytesIn(const std::vector<T>& list) {
  return list.size() * sizeof(T);
}

// In the cursor itself.
std::size_t bytesIn(const std::optional<Worst>&) { return 0; }
std::size_t bytesIn(const CureProgress&) { return 0; }
std::size_t bytesIn(std::uint64_t) { return 0; }
std::size_t bytesIn(const Cursor& cursor) {
  const auto sum = [](const auto&... part) { return (std::size_t{0} + ... + bytesIn(part)); };
  return std::visit([&](const auto& ahead) { return std::apply(sum, ahead.parts()); }, cursor.ahead);
}

}  // namespace

std::size_t bytesOf(const MeshState& s) {
  const Mesh& m = s.mesh;
  return sizeof(MeshState) + bytesIn(m.points) + bytesIn(m.kinds) + bytesIn(m.density) + bytesIn(m.vertexTriangle) +
         bytesIn(m.vertexEdge) + bytesIn(m.triangles) + bytesIn(m.ids) + bytesIn(m.flags) + bytesIn(m.tested) +
         bytesIn(m.freeSlots) + bytesIn(m.edges) + bytesIn(s.constraints) + bytesIn(s.search.found) +
         bytesIn(s.tree.cells) + bytesIn(s.tree.corners) + bytesIn(s.sizes) + bytesIn(s.boundary) + bytesIn(s.front1) +
         bytesIn(s.front2) + bytesIn(s.frontLoops) + bytesIn(s.cursor);
}

bool hasComeTo(const MeshState& state, Stage stage) {
  if (inRounds(stage) && inRounds(state.stage) && state.round > 1) return true;
  return state.stage > stage || (state.stage == stage && state.cursor.begun);
}

void History::restart(const MeshState& start) {
  dropNear();
  keyframes_.clear();
  keyframes_.push_back(std::make_shared<const Keyframe>(Keyframe{start, 0, bytesOf(start)}));
  settings_ = start.settings;
  nearTick_ = kNowhere;
  bytes_ = keyframes_.front()->bytes;
  spacing_ = kFirstSpacing;
  nextWork_ = workOf(start) + spacing_;
}

void History::take(const MeshState& state, std::uint64_t events) {
  TRISCOPE_CHECK(!keyframes_.empty(), "the keyframe of the start is kept whatever the budget");
  const std::size_t size = bytesOf(state);
  if (size > kLargeState) spacing_ = std::max(spacing_, static_cast<std::uint64_t>(size / kBytesPerDecision));
  if (bytes_ + size > budget_) dropNear();
  while (bytes_ + size > budget_ && keyframes_.size() > 1) thin();
  nextWork_ = workOf(keyframes_.back()->state) + spacing_;
  if (bytes_ + size > budget_ || workOf(state) < nextWork_) {
    nextWork_ = std::max(nextWork_, workOf(state) + spacing_);
    return;
  }
  keyframes_.push_back(std::make_shared<const Keyframe>(Keyframe{state, events, size}));
  bytes_ += size;
  nextWork_ = workOf(state) + spacing_;
}

void History::aimAt(std::uint64_t tick, std::uint64_t from) {
  const std::uint64_t way = tick > from ? tick - from : 0;
  nearTick_ = way >= kLeastWay ? tick - std::min(kNear, way / 2) : kNowhere;
  sought_ = tick;
}

void History::takeNear(const MeshState& state, std::uint64_t events) {
  const std::uint64_t left = sought_ - state.tick;
  nearTick_ = left >= kNearest ? sought_ - left / kNearest : kNowhere;
  if (workOf(state) - workOf(before(state.tick).state) < kNear) return;
  dropNear();
  const std::size_t size = bytesOf(state);
  while (bytes_ + size > budget_ && keyframes_.size() > 1) thin();
  if (bytes_ + size > budget_) return;
  near_ = std::make_shared<const Keyframe>(Keyframe{state, events, size});
  bytes_ += size;
}

void History::thin() {
  std::size_t kept = 1;
  for (std::size_t k = 2; k < keyframes_.size(); k += 2) keyframes_[kept++] = std::move(keyframes_[k]);
  keyframes_.resize(kept);
  bytes_ = near_ ? near_->bytes : 0;
  for (const auto& keyframe : keyframes_) bytes_ += keyframe->bytes;
  spacing_ *= 2;
}

void History::dropLast() {
  bytes_ -= keyframes_.back()->bytes;
  keyframes_.pop_back();
}

void History::dropNear() {
  if (near_) bytes_ -= near_->bytes;
  near_.reset();
}

void History::forgetAfter(std::uint64_t tick) {
  if (near_ && near_->state.tick > tick) dropNear();
  while (keyframes_.size() > 1 && keyframes_.back()->state.tick > tick) dropLast();
  nextWork_ = workOf(keyframes_.back()->state) + spacing_;
}

const Keyframe& History::before(std::uint64_t tick) const {
  TRISCOPE_CHECK(!keyframes_.empty(), "a history is begun before it is read");
  const auto after = std::upper_bound(keyframes_.begin(), keyframes_.end(), tick,
                                      [](std::uint64_t t, const auto& k) { return t < k->state.tick; });
  const Keyframe& regular = after == keyframes_.begin() ? **after : **(after - 1);
  const bool nearer = near_ && near_->state.tick <= tick && near_->state.tick > regular.state.tick;
  return nearer ? *near_ : regular;
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
  if (near_ && hasComeTo(near_->state, affected)) dropNear();
  settings_ = settings;
  nextWork_ = workOf(keyframes_.back()->state) + spacing_;
  return keyframes_.back()->state.tick;
}

}  // namespace triscope
