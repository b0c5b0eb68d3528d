// A run of the method that one can go about in, as a value: where it stands, and what is kept of the whole of it. A
// copy is a run of its own, and the two share what never changes: keyframes and checkpoints.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/method/pipeline.h"
#include "core/run/breakpoint.h"
#include "core/run/history.h"
#include "core/run/quality_trace.h"
#include "core/run/run_record.h"

namespace triscope {

/// The state at the first entry into a stage, to begin again from when a setting changes that matters from there on.
/// The settings in it are not to be used: those in force may differ in what cannot have mattered yet.
struct Checkpoint {
  std::shared_ptr<const MeshState> state;
  std::uint64_t events = 0;   // that led to it
  std::optional<Event> last;  // of these
  std::size_t bytes = 0;
};

/// A breakpoint that was met, in words that outlive the list of breakpoints.
struct PassedHit {
  std::uint64_t tick = 0;  // decisions made right after it
  std::string condition;
  Breakpoint::Action action = Breakpoint::Action::stop;
  Event event;
};

struct Run {
  MeshState state;
  std::uint64_t events = 0;   // that led to the state
  std::uint64_t known = 0;    // of the run as far as it has been carried: those after the state too
  std::optional<Event> last;  // that led to the state; nothing at the start and right at a keyframe
  History history;
  RunRecorder recorder;
  QualityTrace trace;
  std::vector<Checkpoint> checkpoints;  // by tick
  std::vector<PassedHit> hits;          // by tick
};

inline constexpr std::size_t kHistoryBytes = std::size_t{256} << 20u;
/// Events that are kept of a run, about half a gigabyte; later ones are made, and not kept.
inline constexpr std::size_t kMostEvents = 16'000'000;

/// A run at its start. `start` is a state at tick 0; `budget` is that of the keyframes, in bytes.
Run runFrom(MeshState start, std::size_t budget = kHistoryBytes);

/// Bytes that a run of so many triangles takes beside its mesh, if all of it is kept.
double historyBytesAtMost(double triangles);

/// Whether a run has begun: a Run that was only constructed has no domain.
inline bool hasBegun(const Run& run) { return run.state.domain != nullptr; }
inline bool isOver(const Run& run) { return run.state.stage == Stage::finished || run.state.failed; }

/// To be told of everything that leads from a state to the next: keeps what is to be kept of it. Returns how many of
/// the events made were not known yet; they are the last of them.
std::size_t keep(Run& run, const Beat& beat, Stage stageBefore);

/// Puts the run back to a keyframe of its own.
void returnTo(Run& run, const Keyframe& keyframe);

/// What comes after the state will be another run: forgets what is known of the old one.
void forgetWhatFollows(Run& run);

/// Takes over settings that cannot have mattered up to the state. What comes after it will be another run.
void takeOver(Run& run, const Settings& settings);

/// The run with other settings, back where they begin to matter, and not before the first checkpoint.
Run branchOf(const Run& run, const Settings& settings);

/// Keeps a breakpoint that was met, unless it is kept already. True when it was not.
bool keepHit(Run& run, const Hit& hit, const Breakpoint& met);

}  // namespace triscope
