// Runs the method for a viewer: owns the domain, the settings and the events so far, and a worker thread that
// carries a private state forward in short slices and publishes immutable snapshots of it. The only writer.
#pragma once

#include <chrono>
#include <functional>

#include "core/run/events.h"
#include "core/session/command.h"
#include "core/session/publication.h"

namespace triscope {

class SessionThread;

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
  [[nodiscard]] bool stale() const { return stale_ || ordersDone_ < settingsOrder_; }
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
  std::unique_ptr<SessionThread> worker_;
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
  std::uint64_t ordersDone_ = 0;     // of them, that the worker has spoken of
  std::uint64_t settingsOrder_ = 0;  // the last of them that changed settings or the domain
};

}  // namespace triscope
