// What is known of a run as a whole, however far back the viewer stands: where its stages begin, where points were
// inserted, and the worst measures along it. Fed by whoever carries the run on; quality_trace.h adds the measures.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/method/state.h"
#include "core/quality/quality.h"
#include "core/quality/running_quality.h"
#include "core/words/event.h"

namespace triscope {

/// A stage as the run came to it; steps 2 to 5 and their repair come once a round.
struct StageEntry {
  Stage stage = Stage::constraints;
  std::uint16_t round = 0;
  std::uint64_t tick = 0;   // decisions before it
  std::uint64_t event = 0;  // number of the event that says so
};

/// What led to a state: a decision, a step into the next stage, or several of the latter and a decision.
struct Beat {
  std::uint64_t tickBefore = 0;
  std::size_t pointsBefore = 0;  // of the mesh
  std::span<const Event> made;   // its events
  std::uint64_t events = 0;      // number of events of the run, with these
};

struct QualitySample {
  std::uint64_t tick = 0;
  std::uint32_t triangles = 0;
  std::uint32_t obtuse = 0;
  std::array<float, kMeasureCount> worst{};  // by Measure; 0 (180 for min_angle) while there is no mesh
};

/// The measures of a mesh in full, as a sample of its tick.
QualitySample sampleOf(std::uint64_t tick, const Quality& quality);

struct RunRecord {
  std::uint64_t ticks = 0;  // decisions known
  bool complete = false;    // the run is over after them
  std::vector<StageEntry> stages;
  std::vector<QualitySample> samples;  // by tick; they may lag behind
};

/// The last entry whose stage begins at or before a tick; nothing for an empty record.
const StageEntry* entryAt(const RunRecord& record, std::uint64_t tick);
/// The entry that a decision was made in, the first being number 1; of 0 decisions the first entry. Where a stage ends
/// and the next begins at the same tick, `entryAt` names the next.
const StageEntry* entryOfDecision(const RunRecord& record, std::uint64_t tick);
/// The first entry into a stage or one after it.
const StageEntry* firstEntry(const RunRecord& record, Stage stage);
/// The last sample at or before a tick: its own tick says what it is a measure of.
const QualitySample* sampleAt(const RunRecord& record, std::uint64_t tick);

class RunRecorder {
 public:
  /// What comes after so many decisions and events will be another run.
  void forgetAfter(std::uint64_t tick, std::uint64_t events);

  /// To be told of every beat, with the state it led to. What is known already is passed by.
  void follow(const MeshState& state, const Beat& beat);

  [[nodiscard]] const RunRecord& record() const { return record_; }
  /// Decisions made right after the last insertion before this tick, 0 when there is none.
  [[nodiscard]] std::uint64_t insertionBefore(std::uint64_t tick) const;
  /// Decisions made once event `index` has happened; nothing when it is not known yet.
  [[nodiscard]] std::optional<std::uint64_t> tickOfEvent(std::uint64_t index) const;
  /// Bytes that it takes, without the record.
  [[nodiscard]] std::size_t bytes() const;

 private:
  /// From this decision on there are so many events more than decisions. Most decisions make one event.
  struct Surplus {
    std::uint64_t tick = 0;
    std::int64_t events = 0;
    [[nodiscard]] std::uint64_t eventsAfter(std::uint64_t decisions) const {
      return static_cast<std::uint64_t>(static_cast<std::int64_t>(decisions) + events);
    }
  };

  /// Decisions that all inserted a point: steps insert for long stretches.
  struct Stretch {
    std::uint64_t first = 0;
    std::uint64_t last = 0;
  };

  RunRecord record_;
  std::vector<Stretch> insertions_;  // by tick
  std::vector<Surplus> surplus_;     // by tick: where it changes
  std::uint64_t events_ = 0;         // known
};

}  // namespace triscope
