// Runs the method for a viewer: owns the domain, the settings and the events so far, and a worker thread that
// carries a private state forward in short slices and publishes immutable snapshots of it. The only writer.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/debug/breakpoint.h"
#include "core/event.h"
#include "core/history/events.h"
#include "core/pipeline.h"
#include "core/quality/quality.h"
#include "core/result.h"
#include "core/run_record.h"
#include "core/settings.h"
#include "core/state.h"

namespace triscope {

/// A state that no longer changes, and what a viewer wants to know of it at once.
struct Snapshot {
  std::uint64_t revision = 0;  // grows with every snapshot of a session
  MeshState state;
  Quality quality;            // of state.mesh; all zero before there is a mesh
  std::optional<Event> last;  // the decision that led here
  std::uint64_t events = 0;   // number of events recorded up to here
};
using SnapshotPtr = std::shared_ptr<const Snapshot>;

/// A breakpoint that was met, in words that outlive the list of breakpoints.
struct PassedHit {
  std::uint64_t tick = 0;  // decisions made right after it
  std::string condition;
  Breakpoint::Action action = Breakpoint::Action::stop;
  Event event;
};

/// What a viewer may ask for. A later command takes the place of one still being carried out.
namespace command {
struct OpenFile {
  std::string path;  // read, checked and meshed to the end; on an error the old mesh stays
};
struct OpenDomain {
  std::shared_ptr<const Domain> domain;  // already checked; meshed to the end
};
struct Load {
  std::shared_ptr<const Domain> domain;  // already checked; meshed to the end …
  Settings settings;                     // … with these
  std::optional<std::uint64_t> tick;     // then back to so many decisions
};
struct Change {
  Settings
      settings;  // re-meshes from the first stage that a difference can matter to, back to the same tick or the end
};
struct Advance {
  Grain grain = Grain::decision;
};
struct Seek {
  std::uint64_t tick = 0;  // decisions from the start; beyond the end is the end
};
struct StepBack {
  Grain grain = Grain::decision;  // stage: to its start, or that of the one before when already there
};
struct SeekEvent {
  std::uint64_t index = 0;  // to right after the decision that this event belongs to
};
struct SetBreakpoints {
  std::vector<Breakpoint> list;
};
struct Continue {
  bool backwards = false;  // to the next, or the last, decision that meets a breakpoint that stops; or the run's end
};
struct FindViolation {};  // to the first decision that breaks a bound or a validity rule; stays when there is none
struct GoTo {
  Stage stage = Stage::constraints;  // to where it begins for the first time, backwards or forwards
};
struct Restart {};
struct Play {
  double decisionsPerSecond = 60.0;
};
struct Pause {};   // stops where the run is
struct Cancel {};  // stops; a re-mesh not yet complete is given up for the mesh and the settings from before
}  // namespace command
using Command =
    std::variant<command::OpenFile, command::OpenDomain, command::Load, command::Change, command::Advance,
                 command::Seek, command::StepBack, command::SeekEvent, command::GoTo, command::Restart, command::Play,
                 command::Pause, command::Cancel, command::SetBreakpoints, command::Continue, command::FindViolation>;

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

class SessionWorker;

/// Everything here belongs to one thread (the viewer's); the worker behind it is reached through commands only.
class Session {
 public:
  /// `wake` is called from the worker whenever poll() has something new; it may be empty.
  explicit Session(std::function<void()> wake = {});
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  void apply(const Command& order);
  /// Takes over what the worker has published since. True when anything a viewer shows has changed.
  bool poll();
  /// Waits at most `patience` for the worker to become idle, then polls. True when it is idle.
  bool settle(std::chrono::milliseconds patience);

  /// The mesh to show; null until the first domain has been read.
  [[nodiscard]] const SnapshotPtr& current() const { return current_; }
  /// True while `current` is the mesh from before a change that is still being carried out.
  [[nodiscard]] bool stale() const { return stale_; }
  /// Events up to `current`, oldest first.
  [[nodiscard]] Events events() const;
  /// Events of the whole run as far as it is known: those after `current` are of decisions gone back over.
  [[nodiscard]] const EventLog& runEvents() const { return events_; }
  /// What is known of the whole run; never null.
  [[nodiscard]] const RunRecord& record() const { return *record_; }
  [[nodiscard]] const std::vector<Breakpoint>& breakpoints() const { return breakpoints_; }
  /// Breakpoints met so far in this run, by tick.
  [[nodiscard]] const std::vector<PassedHit>& hits() const { return *hits_; }
  /// What the last command that searched has to say; empty when nothing.
  [[nodiscard]] const std::string& notice() const { return notice_; }
  [[nodiscard]] const Progress& progress() const { return progress_; }
  [[nodiscard]] bool busy() const { return progress_.activity != Activity::idle; }
  /// Settings in force or being applied.
  [[nodiscard]] const Settings& settings() const { return settings_; }
  /// Domain in force, or being loaded; null until the first has been read.
  [[nodiscard]] const std::shared_ptr<const Domain>& domain() const { return domain_; }
  /// The run at the entry of step 6, once it has come there; null before. Its settings may differ from those in force
  /// in what has not mattered up to there.
  [[nodiscard]] const std::shared_ptr<const MeshState>& beforeRefinement() const { return beforeRefinement_; }
  /// Why the last command failed; cleared by the next one that starts.
  [[nodiscard]] const std::optional<Error>& error() const { return error_; }
  /// How many commands have failed so far: tells a new error from one seen before.
  [[nodiscard]] std::uint64_t failures() const { return failures_; }

 private:
  std::unique_ptr<SessionWorker> worker_;
  SnapshotPtr current_;
  EventLog events_;
  std::shared_ptr<const RunRecord> record_ = std::make_shared<const RunRecord>();
  std::shared_ptr<const std::vector<PassedHit>> hits_ = std::make_shared<const std::vector<PassedHit>>();
  std::vector<Breakpoint> breakpoints_;
  std::string notice_;
  Progress progress_;
  Settings settings_;
  std::shared_ptr<const Domain> domain_;
  std::shared_ptr<const MeshState> beforeRefinement_;
  std::optional<Error> error_;
  std::uint64_t failures_ = 0;
  bool stale_ = false;
  std::uint64_t orders_ = 0;         // commands given
  std::uint64_t settingsOrder_ = 0;  // the last of them that changed settings or the domain
};

}  // namespace triscope
