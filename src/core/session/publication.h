// What a session tells its viewer: a snapshot of the run, and what has changed beside it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/quality/quality.h"
#include "core/run/run.h"

namespace triscope {

/// A state that no longer changes, and what a viewer wants to know of it at once.
struct Snapshot {
  std::uint64_t revision = 0;  // grows with every snapshot of a session
  MeshState state;
  Quality quality;               // of state.mesh; all zero before there is a mesh
  std::optional<Event> last;     // the decision that led here
  std::uint64_t events = 0;      // number of events recorded up to here
  std::uint64_t firstEvent = 0;  // of these, the number of the first that this decision recorded; `events` when none

  /// hashOf(state), worked out when it is first asked for, which takes as long as to make the snapshot. For one thread.
  [[nodiscard]] std::uint64_t hash() const {
    if (!hash_) hash_ = hashOf(state);
    return *hash_;
  }

 private:
  mutable std::optional<std::uint64_t> hash_;
};
using SnapshotPtr = std::shared_ptr<const Snapshot>;

enum class Activity : std::uint8_t {
  idle,
  stepping,
  playing,
  meshing,
  searching,  // through the run for a decision; what is shown stays
};

struct Progress {
  Activity activity = Activity::idle;
  Stage stage = Stage::constraints;  // this and the next four: of the run, or of where a search is
  std::uint64_t tick = 0;
  std::size_t triangles = 0;
  double estimated = 0.0;  // triangles in the end by Table 1; 0 while unknown
  double fraction = 0.0;   // 0 … 1 of the way, a rough estimate
  double seconds = 0.0;    // since the command was given
};

struct Publication {
  SnapshotPtr snapshot;                                // the newest, null when there is no new one
  std::uint64_t keepEvents = 0;                        // with a snapshot: drop the viewer's events beyond this many …
  std::vector<Event> freshEvents;                      // … and append these
  std::shared_ptr<const RunRecord> record;             // null when unchanged, as is the next
  std::shared_ptr<const std::vector<PassedHit>> hits;  // by tick
  std::shared_ptr<const MeshState> beforeRefinement;   // as Session has it, whatever else is new
  std::string notice;
  Progress progress;
  Settings settings;  // in force
  std::shared_ptr<const Domain> domain;
  std::uint64_t ordersDone = 0;  // commands that had been taken up by then
  std::optional<Error> error;
  std::uint64_t failures = 0;
  bool stale = false;
};

/// Adds news to what nobody has taken yet: an earlier snapshot gives way, but its events are still wanted.
void add(Publication& waiting, Publication news);

}  // namespace triscope
