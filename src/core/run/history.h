// Time travel: keyframes of the state within a byte budget, and deterministic replay from the nearest one.
//
// The keyframes thin out as the run goes on: when the budget is full, every second one is dropped and the spacing
// doubles, so that they always cover the whole run evenly in work (ideas: E. Catto's replay in Box2D 3; the proof is
// the same too: seek to every tick in descending order and compare hashes, tests/unit/history_test.cpp). One keyframe
// more is near where somebody is looking around.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/method/pipeline.h"

namespace triscope {

/// Bytes that a copy of the state takes, to a good approximation.
std::size_t bytesOf(const MeshState& state);

/// Whether a run has come to where settings matter that first do so in this stage: the stage has begun, in this round
/// of steps 2-5 or in one before.
bool hasComeTo(const MeshState& state, Stage stage);

/// What drawing, measuring and the events cannot tell: how far the run had come at a keyframe. The settings in it are
/// not to be used: those in force may differ in what cannot have mattered up to there (History::stateBefore).
struct Keyframe {
  MeshState state;
  std::uint64_t events = 0;  // recorded before it
  std::size_t bytes = 0;
};

/// A copy costs next to nothing: it shares the keyframes, which never change.
class History {
 public:
  History() = default;
  /// `budget` is in bytes; the keyframe of the start is kept whatever the budget.
  explicit History(std::size_t budget) : budget_(budget) {}

  /// Forgets everything and begins with a state at tick 0.
  void restart(const MeshState& start);

  /// Offers the state after a decision (`events` recorded so far). Copies it when the next keyframe is due.
  void offer(const MeshState& state, std::uint64_t events) {
    if (workOf(state) >= nextWork_) take(state, events);
    if (state.tick == nearTick_) takeNear(state, events);
  }

  /// A place is sought, from a state at `from`: on the way there one more keyframe is kept shortly before it, in the
  /// place of the last one kept so, because one looks around where one has gone to. Where decisions take long, it is
  /// kept nearer to it.
  void aimAt(std::uint64_t tick, std::uint64_t from);

  /// Drops the keyframes after a tick: what comes next is another run.
  void forgetAfter(std::uint64_t tick);

  /// The last keyframe at or before a tick.
  [[nodiscard]] const Keyframe& before(std::uint64_t tick) const;
  /// A copy of its state, with the settings in force.
  [[nodiscard]] MeshState stateBefore(std::uint64_t tick) const;

  /// The state after `tick` decisions: the nearest keyframe, carried on. A tick beyond the end gives the end.
  /// Events of the replay go to the journal, those of decisions before the keyframe do not.
  [[nodiscard]] MeshState seek(std::uint64_t tick, Journal& journal) const;

  /// Settings that the keyframes are to be carried on with: a change that cannot have mattered before a keyframe
  /// leaves it valid. Drops the keyframes that it could have mattered to; returns the tick of the last one left.
  std::uint64_t changeSettings(const Settings& settings);

  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  [[nodiscard]] std::size_t count() const { return keyframes_.size() + (near_ ? 1 : 0); }
  [[nodiscard]] std::uint64_t spacing() const { return spacing_; }

 private:
  void take(const MeshState& state, std::uint64_t events);
  void takeNear(const MeshState& state, std::uint64_t events);
  void thin();
  void dropLast();
  void dropNear();

  std::vector<std::shared_ptr<const Keyframe>> keyframes_;  // by tick; the first is the start
  Settings settings_;                                       // in force
  std::size_t budget_ = std::size_t{64} << 20;
  std::size_t bytes_ = 0;
  std::uint64_t spacing_ = 1024;  // work between keyframes at least, in decisions
  std::uint64_t nextWork_ = 0;
  std::shared_ptr<const Keyframe> near_;           // before the place last sought; often none
  std::uint64_t nearTick_ = std::uint64_t{0} - 1;  // where the next such one is due
  std::uint64_t sought_ = 0;                       // that place
};

}  // namespace triscope
