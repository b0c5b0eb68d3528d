// The thread behind a Session. Commands go in, publications come out; nothing else is shared.
#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "core/history/history.h"
#include "core/quality_trace.h"
#include "core/session.h"

namespace triscope {

/// What the worker has to tell since it was last asked.
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

class SessionWorker {
 public:
  explicit SessionWorker(std::function<void()> wake);
  ~SessionWorker();
  SessionWorker(const SessionWorker&) = delete;
  SessionWorker& operator=(const SessionWorker&) = delete;

  void order(const Command& command);
  /// Nothing when nothing was published since the last call.
  std::optional<Publication> take();
  bool waitIdle(std::chrono::milliseconds patience);

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::size_t kHistoryBytes = std::size_t{256} << 20u;

  static constexpr std::uint64_t kUnknown = ~std::uint64_t{0};

  /// What the worker is heading for.
  struct Goal {
    enum class Kind : std::uint8_t {
      none,
      insertion,
      stage,
      round,
      tick,
      entry,
      end,
      play,
      breakpoint
    } kind = Kind::none;
    Stage stage = Stage::constraints;  // stage, round: where the step began; entry: where to stop
    std::uint16_t round = 0;
    std::size_t vertices = 0;  // insertion: how many there were
    std::uint64_t tick = 0;    // tick: where to stop; entry: decisions before it, kUnknown when not known
    double rate = 0.0;         // play: decisions per second
    std::optional<std::uint64_t> then = std::nullopt;  // end: decisions to go back to from there
  };

  /// The state at the first entry into a stage, to go back to. The settings in it are not to be used: those in force
  /// may differ in what cannot have mattered yet.
  struct Checkpoint {
    std::shared_ptr<const MeshState> state;
    std::uint64_t events = 0;
    std::optional<Event> last;
    std::size_t bytes = 0;
  };

  /// What a re-mesh that is given up returns to: as published last.
  struct Backup {
    Checkpoint at;
    std::vector<Checkpoint> checkpoints;
    RunRecorder recorder;
    QualityTrace trace;
    std::vector<PassedHit> hits;
    std::uint64_t known = 0;
    std::uint64_t kept = 0;
    // Keyframes: those up to `branch` are still in history_, unless `whole` has them all.
    std::uint64_t branch = kUnknown;
    std::vector<Keyframe> later;
    std::optional<History> whole;
  };

  void loop();
  /// Does it; where memory does not suffice, gives the run up and says so.
  template <class Work>
  void survive(const Work& work);
  void giveUp();
  void carryOut(const Command& command);
  void open(std::shared_ptr<const Domain> domain);
  void load(const command::Load& what);
  void change(const Settings& settings);
  void seek(std::uint64_t tick);
  void seekEntry(const StageEntry& entry);
  void seekEvent(std::uint64_t index);
  void stepBack(Grain grain);
  void goTo(Stage stage);
  void setBreakpoints(std::vector<Breakpoint> list);
  void goOn(bool backwards);
  void goBackToBreakpoint();
  void findViolation();
  /// For a search through `total` decisions (0: not known how many): tells now and then how far it is, and gives it up
  /// when a command waits.
  SearchPulse searchPulse(std::uint64_t total);
  void cancel();
  void head(Goal goal, Activity activity);
  void headFor(Grain grain);
  void halt();
  void rest(std::string notice);  // where the run is, after a search that led nowhere
  void fail(Error error);

  void slice();
  void carry(std::uint64_t beats);
  void carryWatching(Clock::time_point end);
  /// Takes in the events of a beat, in beat_, that led to state_.
  Beat recordBeat(std::uint64_t tickBefore, std::size_t pointsBefore);
  [[nodiscard]] bool over() const { return state_.stage == Stage::finished || state_.failed; }
  [[nodiscard]] bool reached() const;
  void takeHit(const Hit& hit, std::span<const Breakpoint> breakpoints);

  bool startOver(std::shared_ptr<const Domain> domain, const Settings& settings);
  void returnTo(const MeshState& state, std::uint64_t events);
  void cutRun();                               // what comes after state_ will be another run
  void setAsideHistory(std::uint64_t branch);  // keyframes after it, for the run that is being given up
  void rejoinHistory();                        // puts them back
  void rememberStage();
  void keepBackup();

  [[nodiscard]] bool traceLags() const;
  void carryTrace();
  [[nodiscard]] std::shared_ptr<const RunRecord> record() const;
  [[nodiscard]] std::shared_ptr<const MeshState> beforeRefinement() const;
  void publishState();
  void publishProgress();
  /// Tells how far the search for Δx is; false when a command waits.
  bool tellOfDeriving(const MeshState& probe, double fraction);
  /// Whether a command waits that takes the place of what is being begun; the others are for what comes of it.
  bool supersedes(bool opening);
  void publishBeginning(const MeshState& probe, double fraction);
  void publishSearch(const MeshState& probe, std::optional<double> fraction);
  [[nodiscard]] Progress progressAt(const MeshState& state) const;
  Publication& outbox();

  std::function<void()> wake_;

  // Shared, under mutex_.
  std::mutex mutex_;
  std::condition_variable inboxChanged_;
  std::condition_variable becameIdle_;
  std::deque<Command> inbox_;
  std::optional<Publication> outbox_;
  bool idle_ = true;
  bool quit_ = false;
  std::atomic<bool> interrupt_{false};  // a command waits: searches are to stop

  // The worker's own.
  MeshState state_;
  bool loaded_ = false;
  std::uint64_t recorded_ = 0;  // events that lead to state_
  std::uint64_t known_ = 0;     // events of the run, those after state_ too
  std::uint64_t kept_ = 0;      // of these, the viewer has the first kept_ …
  std::vector<Event> fresh_;    // … and these are the rest
  std::vector<Event> beat_;     // of the beat being made
  std::optional<Event> last_;
  std::vector<Checkpoint> checkpoints_;  // by tick
  std::optional<Backup> backup_;         // while a re-mesh is under way
  History history_{kHistoryBytes};
  RunRecorder recorder_;
  QualityTrace trace_;
  std::vector<Breakpoint> breakpoints_;
  std::optional<Watch> watch_;  // while the goal is a breakpoint
  std::vector<PassedHit> hits_;
  std::string heldFromStart_;  // a condition that held where the watch began, which is no hit
  bool stopped_ = false;       // the last decision met a breakpoint that stops
  bool recordChanged_ = false;
  bool hitsChanged_ = false;
  std::string notice_;
  Goal goal_;
  Activity activity_ = Activity::idle;
  std::optional<Error> error_;
  std::uint64_t failures_ = 0;
  std::uint64_t revision_ = 0;
  std::uint64_t ordersDone_ = 0;
  std::uint64_t chunk_ = 64;  // decisions in a slice, adapted to a few milliseconds
  double owed_ = 0.0;         // play: decisions that time has earned
  Clock::time_point goalSince_{};
  Clock::time_point lastSlice_{};
  Clock::time_point lastPublished_{};
  Clock::time_point lastTrace_{};
  Clock::duration publishCost_{};

  std::thread thread_;  // last: starts when everything above is ready
};

}  // namespace triscope
